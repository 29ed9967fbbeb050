# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Captions that list the parameters of a model."""

import re
import textwrap

from repose import style

LETTERS_PER_INCH = 19  # of a caption, on average
LINE = 0.13  # inch


def add(figure, model, leave_out=()):
    """Writes name and parameters of a model above a figure, in as many lines as they need; their height [inch]."""
    shown = (parameter for parameter in model.parameters if parameter.name not in leave_out)
    written = ", ".join(f"{p.name}\N{NO-BREAK SPACE}=\N{NO-BREAK SPACE}{_short(p.value)}" for p in shown)
    width = figure.get_size_inches()[0]
    lines = textwrap.wrap(f"{model.name}: {written}", int(LETTERS_PER_INCH * width), break_long_words=False)
    style.caption(figure, "\n".join(lines))
    return 0.1 + LINE * len(lines)


def _short(value):
    """Four digits of a number with a decimal point; other values as written."""
    return f"{float(value):.4g}" if re.fullmatch(r"-?\d+\.\d+(e-?\d+)?", value) else value


def fit_below(figure, height):
    """Lays out the axes below a caption of this height [inch]."""
    style.fit(figure, (0.0, 0.0, 1.0, 1.0 - height / figure.get_size_inches()[1]))
