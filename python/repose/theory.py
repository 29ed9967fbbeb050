# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The stress models as numpy arrays: the same bits as `repose theory` prints.

>>> from repose import theory
>>> pile = theory.predict("pile-continuum", slope_deg=30)
>>> pile["x_over_b"].shape, round(float(pile["normal"].max()), 12)
((201,), 0.25)
"""

from dataclasses import dataclass

import numpy as np

import repose_compiled

InputError = repose_compiled.InputError  # a ValueError with one line for every problem


@dataclass(frozen=True)
class Parameter:
    """A parameter of a model, as text."""

    name: str  #: as in `predict(model, name=value)`
    value: str  #: its value or default; "" where it must be given
    unit: str  #: "" for a pure number or a word
    allowed: str  #: bounds or words
    about: str  #: its meaning


@dataclass(frozen=True)
class Model:
    """A model: name, description, source and parameters."""

    name: str  #: as in `predict(name)`
    about: str  #: what it predicts
    source: str  #: publication and equations
    parameters: tuple  #: of Parameter

    @property
    def settings(self):
        """Values of the parameters by name, as text."""
        return {parameter.name: parameter.value for parameter in self.parameters}

    def value(self, name):
        """Value of a parameter, as text."""
        return self.settings[name]


@dataclass(frozen=True)
class Quantity:
    """A column (an array or a list of words) or a single number of a prediction."""

    name: str  #: as in `prediction[name]`
    unit: str  #: "1" for a pure number
    about: str  #: its meaning
    value: object  #: array (n,), list of words, or number


class Prediction:
    """Columns and single numbers of a model, by name."""

    def __init__(self, model, columns, numbers):
        self.model = model
        self.columns = {column.name: column for column in columns}
        self.numbers = {number.name: number for number in numbers}

    def __getitem__(self, name):
        """An array (n,), a list of words, or a number; KeyError for an unknown name."""
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


def _as_text(value):
    """A value as text for the command line; numbers keep their bits."""
    if isinstance(value, str):
        return value
    return str(int(value)) if isinstance(value, (int, np.integer)) else repr(float(value))


def predict(model, /, **settings):
    """Prediction of a model; InputError (a ValueError) names everything that is wrong with the settings."""
    written = [(name, _as_text(value)) for name, value in settings.items()]
    description, (columns, numbers) = repose_compiled.theory_prediction(model, written)
    return Prediction(
        _model(description), [Quantity(*entry) for entry in columns], [Quantity(*entry) for entry in numbers]
    )
