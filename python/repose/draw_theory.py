# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Draws a stress model: `python3 -m repose.draw_theory MODEL --plot FILE`, or `repose theory MODEL --plot FILE`."""

import argparse
import sys
from pathlib import Path

from repose import style, theory
from repose.errors import complain
from repose.pictures.models import draw_model


def _draw(options):
    prediction = theory.predict(options.model, **dict(setting.split("=", 1) for setting in options.set))
    with style.context():
        figure = draw_model(prediction)
        style.save(figure, options.plot, Path(options.plot).suffix[1:], options.dpi, prediction.model.about)


def main(arguments=None):
    """Exit status 0, or 2 with one line for every problem on stderr."""
    parser = argparse.ArgumentParser(prog="repose theory")
    parser.add_argument("model")
    parser.add_argument("--set", action="append", default=[], metavar="KEY=VALUE")
    parser.add_argument("--plot", required=True, metavar="FILE")
    parser.add_argument("--dpi", type=int, default=200)
    options = parser.parse_args(arguments)
    try:
        _draw(options)
    except theory.InputError as error:
        complain(error)
        return 2
    except KeyboardInterrupt:
        return 130
    except OSError as error:
        complain(f"repose theory: {error.filename or options.plot}: cannot be written: {error.strerror}")
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
