# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the standard pictures of a run folder: `python3 -m repose.plot DIR`, or `repose plot DIR`."""

import argparse
import os
import sys

import matplotlib

from repose import style
from repose.not_drawn import NotDrawn
from repose.pictures import PICTURES
from repose.run_folder import RunFolder, RunFolderError

FORMATS = ("png", "svg")


class Parser(argparse.ArgumentParser):
    """Complains in one line."""

    def error(self, message):
        self.exit(2, f"{self.prog}: {message}\n")


def list_of(known):
    """Reads comma-separated names out of the known ones."""

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
    """Reads the number of a frame."""
    if not text.isdigit():
        raise argparse.ArgumentTypeError(f"'{text}' is not the number of a frame")
    return text


def parse(arguments):
    parser = Parser(prog="repose plot", description="Draw the standard pictures of a run folder into DIR/pictures.")
    parser.add_argument("folder", metavar="DIR", help="run folder")
    parser.add_argument(
        "--only", type=list_of(PICTURES), default=list(PICTURES), metavar="NAMES", help=f"of {','.join(PICTURES)}"
    )
    parser.add_argument("--format", type=list_of(FORMATS), default=list(FORMATS), metavar="KINDS", help="png,svg")
    parser.add_argument("--dpi", type=dots_per_inch, default=200, metavar="N", help="of PNG (default: 200)")
    parser.add_argument("--frame", type=frame_name, metavar="NNNNNN", help="a saved frame instead of the last state")
    return parser.parse_args(arguments)


def save(figure, path, kind, dpi, title):
    """Writes a picture under a temporary name and renames it, so that nobody meets half a file."""
    metadata = {"Title": title, "Date": None} if kind == "svg" else {"Title": title}
    temporary = path.with_name(f".{path.name}.{os.getpid()}")
    try:
        figure.savefig(temporary, format=kind, dpi=dpi, metadata=metadata)
        os.replace(temporary, path)
    finally:
        temporary.unlink(missing_ok=True)


def draw_pictures(run, state, options):
    """Draws what the options name; one line for each file written and each picture left out."""
    folder = run.path / "pictures"
    folder.mkdir(exist_ok=True)
    suffix = f"-{state.frame}" if state.frame else ""
    for name in options.only:
        with matplotlib.rc_context(style.RC):
            try:
                figure = PICTURES[name](run, state)
            except NotDrawn as reason:
                print(f"{name}: not drawn: {reason}")
                continue
            for kind in options.format:
                path = folder / f"{name}{suffix}.{kind}"
                save(figure, path, kind, options.dpi, run.attributes["title"])
                print(path)


def main(arguments=None):
    """Exit status 0, or 2 with one line on stderr."""
    options = parse(arguments)
    try:
        run = RunFolder(options.folder)
        draw_pictures(run, run.frame(options.frame) if options.frame else run.state, options)
    except RunFolderError as error:
        print(f"repose plot: {error}", file=sys.stderr)
        return 2
    except OSError as error:
        print(f"repose plot: {error.filename or options.folder}: cannot be written: {error.strerror}", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
