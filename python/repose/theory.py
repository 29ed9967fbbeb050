# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The stress models of theory, as numpy arrays: what `repose theory` prints, to the bit.

>>> from repose import theory
>>> pile = theory.predict("pile-continuum", slope_deg=30)
>>> pile["x_over_b"].shape, round(float(pile["normal"].max()), 12)
((201,), 0.25)

`python3 -m repose.theory MODEL --plot FILE` draws a model.
"""

import argparse
import sys
from dataclasses import dataclass
from pathlib import Path

import numpy as np

import repose_compiled

InputError = repose_compiled.InputError  # a ValueError: one line for every problem


@dataclass(frozen=True)
class Parameter:
    """A parameter of a model, as written."""

    name: str
    value: str  # what it has, or its default; "" where it must be given
    unit: str
    allowed: str
    about: str


@dataclass(frozen=True)
class Model:
    """How a model is listed, with the parameters that it has."""

    name: str
    about: str
    source: str
    parameters: tuple

    @property
    def settings(self):
        """What the parameters have, as written, by name."""
        return {parameter.name: parameter.value for parameter in self.parameters}

    def value(self, name):
        """What the parameter of this name has, as written."""
        return self.settings[name]


@dataclass(frozen=True)
class Quantity:
    """A column (array, or list of words) or a single number of a prediction."""

    name: str
    unit: str
    about: str
    value: object


class Prediction:
    """Columns and single numbers of a model, by name."""

    def __init__(self, model, columns, numbers):
        self.model = model
        self.columns = {column.name: column for column in columns}
        self.numbers = {number.name: number for number in numbers}

    def __getitem__(self, name):
        """An array (n,), a list of words, or a number; KeyError where there is none."""
        return (self.columns[name] if name in self.columns else self.numbers[name]).value

    def unit(self, name):
        """Unit of a column or number; "1" for a pure number."""
        return (self.columns[name] if name in self.columns else self.numbers[name]).unit


def _model(description):
    parameters = tuple(Parameter(*words) for words in description["parameters"])
    return Model(description["name"], description["about"], description["source"], parameters)


def models():
    """All models with their defaults, by name."""
    return {text["name"]: _model(text) for text in repose_compiled.theory_descriptions()}


def _written(value):
    """A value as the command line has it; numbers keep their bits."""
    if isinstance(value, str):
        return value
    return str(int(value)) if isinstance(value, (int, np.integer)) else repr(float(value))


def predict(model, /, **settings):
    """Prediction of a model; InputError (a ValueError) says all that is wrong with the settings."""
    written = [(name, _written(value)) for name, value in settings.items()]
    description, (columns, numbers) = repose_compiled.theory_prediction(model, written)
    return Prediction(
        _model(description), [Quantity(*entry) for entry in columns], [Quantity(*entry) for entry in numbers]
    )


def _draw(options):
    import matplotlib

    from repose import style
    from repose.theory_pictures import figure_of

    prediction = predict(options.model, **dict(setting.split("=", 1) for setting in options.set))
    with matplotlib.rc_context(style.RC):
        figure = figure_of(prediction)
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
    except InputError as error:
        print(error, file=sys.stderr)
        return 2
    except OSError as error:
        print(f"repose theory: {error.filename or options.plot}: cannot be written: {error.strerror}", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
