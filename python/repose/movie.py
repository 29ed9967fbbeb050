# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the saved frames of a run as a movie: `repose export DIR --to movie`."""

import argparse
import os
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ProcessPoolExecutor
from dataclasses import replace
from multiprocessing import get_context
from pathlib import Path

import repose
from repose import style
from repose.errors import NotDrawn, complain, say
from repose.pictures import pictures_of_run
from repose.pictures.run.common_axes import common_axes
from repose.plot import Parser

FORMATS = ("mp4", "webm", "gif")
PICTURES = ("heap", "forces", "density")  # of frames, which have grains and contacts alone
OF_SPHERES = {"heap": "projection", "forces": "forces"}  # what they are of spheres
USUAL = {2: "forces", 3: "heap"}  # by dimension
EVEN = "pad=ceil(iw/2)*2:ceil(ih/2)*2:color=white"  # codecs take even sizes
CODECS = {
    "mp4": ["-vf", EVEN, "-c:v", "libx264", "-pix_fmt", "yuv420p", "-crf", "18", "-movflags", "+faststart"],
    "webm": ["-vf", EVEN, "-c:v", "libvpx-vp9", "-pix_fmt", "yuv420p", "-crf", "24", "-b:v", "0"],
    "gif": ["-vf", "split[a][b];[a]palettegen=stats_mode=diff[p];[b][p]paletteuse=dither=none"],
}


def whole_number(low, high):
    """A reader of whole numbers."""

    def read(text):
        if not text.isdigit() or not low <= int(text) <= high:
            raise argparse.ArgumentTypeError(f"'{text}' is not a whole number from {low} to {high}")
        return int(text)

    return read


def parser():
    new = Parser(prog="repose export", description="Draw the saved frames of a run as a movie.")
    new.add_argument("folder", metavar="DIR")
    new.add_argument("out", metavar="OUT", help="folder to write")
    new.add_argument("--picture", choices=PICTURES)
    new.add_argument("--format", choices=FORMATS, default="mp4")
    new.add_argument("--fps", type=whole_number(1, 120), default=25)
    new.add_argument("--dpi", type=whole_number(10, 1200), default=150)
    new.add_argument("--threads", type=whole_number(0, 4096), default=0)
    new.add_argument("--quiet", action="store_true")
    return new


def picture_of(run, name):
    """The function that draws one of PICTURES; NotDrawn where a run of spheres has no such picture."""
    if run.attributes["dimension"] == 3:
        if name not in OF_SPHERES:
            raise NotDrawn(f"{name}: is drawn in two dimensions alone")
        name = OF_SPHERES[name]
    return pictures_of_run(run)[name]


def draw_frame(run, axes, name, options, path):
    """Draws one state into a PNG."""
    state = replace(run.frame(name) if name else run.state, axes=axes)
    with style.context():
        style.save(picture_of(run, options.picture)(run, state), path, "png", options.dpi, run.attributes["title"])


_shared = {}  # of a worker: what all its frames have in common


def _prepare(folder, options):
    run = repose.open(folder)
    _shared.update(run=run, axes=common_axes(run), options=options)


def _draw(task):
    draw_frame(_shared["run"], _shared["axes"], *task[:1], _shared["options"], task[1])


def draw_frames(run, options, place):
    """Draws every frame and the last state as NNNNNN.png; returns how many there are."""
    names = [*run.frames, None]
    tasks = [(name, place / f"{number:06d}.png") for number, name in enumerate(names)]
    workers = min(options.threads or os.cpu_count() or 1, len(tasks))
    progress = sys.stderr.isatty() and not options.quiet
    with ProcessPoolExecutor(workers, get_context("spawn"), _prepare, (options.folder, options)) as pool:
        for done, _ in enumerate(pool.map(_draw, tasks), 1):
            if progress:
                print(f"\rframe {done} of {len(tasks)}", end="" if done < len(tasks) else "\n", file=sys.stderr, flush=True)
    return len(tasks)


def encode(place, options, path):
    """Makes a movie from the pictures of a folder. Raises OSError with the last line of ffmpeg."""
    command = ["ffmpeg", "-nostdin", "-loglevel", "error", "-y", "-framerate", str(options.fps), "-i", str(place / "%06d.png"),
               *CODECS[options.format], "-fflags", "+bitexact", "-flags:v", "+bitexact", str(path)]
    result = subprocess.run(command, capture_output=True, text=True, errors="replace")
    if result.returncode != 0:
        last = (result.stderr.strip().splitlines() or ["no message"])[-1]
        raise OSError(f"ffmpeg cannot make {path.name}: {last}")


def export_movie(options):
    """Writes the movie, or the pictures where there is no ffmpeg; returns the path of what was written."""
    run = repose.open(options.folder)
    if isinstance(run, repose.SweepFolder):
        raise repose.RunFolderError(f"{run.path}: a sweep has no frames")
    if not run.frames:
        raise repose.RunFolderError(f"{run.path}: no frame was saved (output.frames)")
    options.picture = options.picture or USUAL[run.attributes["dimension"]]
    picture_of(run, options.picture)  # refuses before anything is written
    out = Path(options.out)
    out.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=out, prefix=".unfinished-") as unfinished:
        place = Path(unfinished)
        count = draw_frames(run, options, place)
        if shutil.which("ffmpeg") is None:
            series = out / options.picture
            shutil.rmtree(series, ignore_errors=True)
            pictures = place / "pictures"
            pictures.mkdir()
            for path in place.glob("*.png"):
                path.rename(pictures / path.name)
            pictures.rename(series)
            return series, count
        made = place / f"movie.{options.format}"
        encode(place, options, made)
        path = out / f"{options.picture}.{options.format}"
        made.replace(path)
        return path, count


def main(arguments=None):
    """Exit status 0, or 2 with one line on stderr."""
    options = parser().parse_args(arguments)
    try:
        path, count = export_movie(options)
    except (repose.RunFolderError, NotDrawn) as error:
        complain(f"repose export: {error}")
        return 2
    except KeyboardInterrupt:
        return 130
    except OSError as error:
        complain(f"repose export: {error.filename or options.out}: {error.strerror or error}")
        return 2
    if not options.quiet:
        say(path)
        if path.is_dir():
            say(f"{count} pictures; ffmpeg, which makes a movie of them, is not installed")
        else:
            say(f"{count} pictures, {count / options.fps:.3g} s")
    return 0


if __name__ == "__main__":
    sys.exit(main())
