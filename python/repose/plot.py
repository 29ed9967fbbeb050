# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Draw the standard pictures of a run folder: `repose plot DIR`, or python3 -m repose.plot DIR."""

import argparse
import os
import sys

from repose.pictures import PICTURES, NotDefined
from repose.run_folder import RunFolder, RunFolderError
from repose.style import plt

FORMATS = ("png", "svg")


def chosen(text, known, what):
    """Splits a comma-separated list and refuses unknown words."""
    words = [word.strip() for word in text.split(",")]
    for word in words:
        if word not in known:
            raise RunFolderError(f"no {what} '{word}'; known: {', '.join(known)}")
    return words


def save(figure, folder, name, kind, dpi):
    """Writes a picture under a temporary name and renames it."""
    path = os.path.join(folder, f"{name}.{kind}")
    temporary = f"{path}.tmp"
    figure.savefig(temporary, format=kind, dpi=dpi, metadata={"Date": None} if kind == "svg" else None)
    os.replace(temporary, path)
    return path


def draw(directory, names, formats, dpi, frame):
    """Draws the named pictures of one folder; returns the paths written."""
    run = RunFolder(directory)
    state = run.state(frame)
    folder = os.path.join(directory, "pictures")
    try:
        os.makedirs(folder, exist_ok=True)
    except OSError as error:
        raise RunFolderError(f"{folder}: cannot write: {error.strerror}") from error
    written = []
    for name in names:
        try:
            figure = PICTURES[name](run, state)
        except NotDefined as reason:
            print(f"{name}: not drawn: {reason}")
            continue
        stem = name if frame is None else f"{name}-{frame}"
        for kind in formats:
            try:
                written.append(save(figure, folder, stem, kind, dpi))
            except OSError as error:
                raise RunFolderError(f"{folder}/{stem}.{kind}: cannot write: {error.strerror}") from error
            print(written[-1])
        plt.close(figure)
    return written


def main(arguments=None):
    parser = argparse.ArgumentParser(prog="repose plot", description=__doc__)
    parser.add_argument("directory", metavar="DIR", help="run folder")
    parser.add_argument("--only", default=",".join(PICTURES), help="pictures, e.g. heap,forces (default: all)")
    parser.add_argument("--format", default=",".join(FORMATS), help="png,svg (default: both)")
    parser.add_argument("--dpi", type=int, default=200, help="resolution of PNG (default: 200)")
    parser.add_argument("--frame", help="a saved frame, e.g. 000003 (default: the last state)")
    options = parser.parse_args(arguments)
    try:
        names = chosen(options.only, PICTURES, "picture")
        formats = chosen(options.format, FORMATS, "format")
        draw(options.directory, names, formats, options.dpi, options.frame)
    except RunFolderError as error:
        print(error, file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
