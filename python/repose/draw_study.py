# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the figures of studies: `python3 -m repose.draw_study RESULTS STATUS STUDY...`, called by `repose study run`."""

import sys
from pathlib import Path

from repose import style
from repose.errors import NotDrawn, RunFolderError, complain, say
from repose.pictures.study import draw_figure
from repose.study_folder import StudyFolder

FORMATS = ("png", "svg")
DPI = 110  # enough for a page; the svg has all


def draw(folder):
    """Draws the figure of a study folder; prints a line for each file, or why there is none."""
    study = StudyFolder(folder)
    with style.context():
        try:
            figure = draw_figure(study)
        except NotDrawn as reason:
            say(f"{study.name}: not drawn: {reason}")
            return
        for kind in FORMATS:
            path = study.path / f"figure.{kind}"
            style.save(figure, path, kind, DPI, study.title)
            say(path)


def main(arguments=None):
    """The exit status that the program wants, or 2 with one line on stderr."""
    results, status, *studies = sys.argv[1:] if arguments is None else arguments
    try:
        for name in studies:
            draw(Path(results, *name.split(".", 1)))
    except RunFolderError as error:
        complain(f"repose study: {error}")
        return 2
    except KeyboardInterrupt:
        return 130
    except OSError as error:
        complain(f"repose study: {error.filename}: cannot be written: {error.strerror}")
        return 2
    return int(status)


if __name__ == "__main__":
    sys.exit(main())
