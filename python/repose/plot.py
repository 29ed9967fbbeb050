# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the pictures of a run or sweep folder: `python3 -m repose.plot DIR`, or `repose plot DIR`."""

import argparse
import sys
from dataclasses import replace
from functools import partial

import repose
from repose import style
from repose.errors import NotDrawn, complain, say
from repose.pictures import pictures_of_run
from repose.pictures.run import RUN_PICTURES
from repose.pictures.run.common_axes import common_axes
from repose.pictures.spheres import SPHERE_PICTURES
from repose.pictures.sweep import SWEEP_PICTURES

FORMATS = ("png", "svg", "pdf", "eps")
USUAL_FORMATS = ("png", "svg")
KNOWN = {"a run": RUN_PICTURES, "a run of spheres": SPHERE_PICTURES, "a sweep": SWEEP_PICTURES}


class Parser(argparse.ArgumentParser):
    """Reports errors in one line."""

    def error(self, message):
        self.exit(2, f"{self.prog}: {message}\n")


def list_of(known):
    """A reader of comma-separated names, all of which must be known."""

    def read(text):
        names = [name.strip() for name in text.split(",")]
        for name in names:
            if name not in known:
                raise argparse.ArgumentTypeError(f"unknown name '{name}', choose from {', '.join(known)}")
        return names

    return read


def dots_per_inch(text):
    """Reads a resolution between 10 and 2400."""
    if not text.isdigit() or not 10 <= int(text) <= 2400:
        raise argparse.ArgumentTypeError(f"'{text}' is not a whole number from 10 to 2400")
    return int(text)


def frame_name(text):
    """Reads the number of a frame, or "all"."""
    if not text.isdigit() and text != "all":
        raise argparse.ArgumentTypeError(f"'{text}' is not the number of a frame")
    return text


def parser():
    new = Parser(
        prog="repose plot", description="Draw the pictures of a run or sweep folder into DIR/pictures."
    )
    new.add_argument("folder", metavar="DIR", help="run folder or sweep folder")
    known = "; of ".join(f"{kind}: {','.join(names)}" for kind, names in KNOWN.items())
    new.add_argument("--only", metavar="NAMES", help=f"of {known}")
    kinds = f"{','.join(FORMATS)} (default: {','.join(USUAL_FORMATS)})"
    new.add_argument("--format", type=list_of(FORMATS), default=list(USUAL_FORMATS), metavar="KINDS", help=kinds)
    new.add_argument("--dpi", type=dots_per_inch, default=200, metavar="N", help="resolution of PNG (default: 200)")
    new.add_argument("--frame", type=frame_name, metavar="NNNNNN", help="a saved frame of a run, not its last state; all: every frame")
    axes = new.add_mutually_exclusive_group()
    same = "size, axes and scale of forces of all frames and the last state (default of frames)"
    axes.add_argument("--same-axes", action="store_true", default=None, help=same)
    own = "those of the state alone (default of the last state)"
    axes.add_argument("--own-axes", action="store_false", dest="same_axes", help=own)
    return new


def states_of(run, frame, same_axes):
    """The states of a run to draw, each with its axes."""
    axes = common_axes(run) if (same_axes is None and frame) or same_axes else None
    if frame is None:
        return [replace(run.state, axes=axes)]
    if frame == "all" and not run.frames:
        raise repose.RunFolderError(f"{run.path}: no frame was saved (output.frames)")
    return (replace(run.frame(name), axes=axes) for name in (run.frames if frame == "all" else [frame]))


def pictures_of(folder, options):
    """Pairs of a suffix of file names and, by name, functions without arguments that return lists of figures."""
    if isinstance(folder, repose.SweepFolder):
        if options.frame or options.same_axes is not None:
            raise repose.RunFolderError(f"{folder.path}: a sweep has no frames")
        yield "", {name: partial(draw, folder) for name, draw in SWEEP_PICTURES.items()}
        return
    for state in states_of(folder, options.frame, options.same_axes):
        suffix = f"-{state.frame}" if state.frame else ""
        yield suffix, {name: partial(_one, draw, folder, state) for name, draw in pictures_of_run(folder).items()}


def _one(draw, run, state):
    return [draw(run, state)]


def draw_pictures(folder, pictures, suffix, options, said):
    """Prints a line for each file written and each picture left out, unless it is one of the lines `said`, to which it is
    added. The second figure of a picture ends in -2."""
    place = folder.path / "pictures"
    place.mkdir(exist_ok=True)
    for name, draw in pictures.items():
        with style.context():
            try:
                figures = draw()
            except NotDrawn as reason:
                line = f"{name}: not drawn: {reason}"
                if line not in said:
                    say(line)
                said.add(line)
                continue
            for k, figure in enumerate(figures, 1):
                for kind in options.format:
                    path = place / f"{name}{suffix}{f'-{k}' if k > 1 else ''}.{kind}"
                    style.save(figure, path, kind, options.dpi, folder.attributes["title"])
                    say(path)


def main(arguments=None):
    """Exit status 0, or 2 with one line on stderr."""
    command = parser()
    options = command.parse_args(arguments)
    try:
        folder = repose.open(options.folder)
        said = set()
        for suffix, pictures in pictures_of(folder, options):
            if options.only is not None:
                try:
                    pictures = {name: pictures[name] for name in list_of(pictures)(options.only)}
                except argparse.ArgumentTypeError as error:
                    command.error(f"argument --only: {error}")
            draw_pictures(folder, pictures, suffix, options, said)
    except repose.RunFolderError as error:
        complain(f"repose plot: {error}")
        return 2
    except KeyboardInterrupt:
        return 130
    except OSError as error:
        complain(f"repose plot: {error.filename or options.folder}: cannot be written: {error.strerror}")
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
