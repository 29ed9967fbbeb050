# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Stress models in Python: names, units, errors, the examples of the documentation, and their pictures."""

import doctest
import os
import subprocess
import sys

import numpy as np
import pytest

from repose import draw_theory, theory
from repose.pictures.models import MODEL_PICTURES


def test_examples_of_the_documentation():
    assert doctest.testmod(theory) == (0, 3)


def test_arrays_units_and_parameters():
    pile = theory.predict("pile-continuum", slope_deg=45, points=11)
    assert pile["normal"].shape == (11,) and pile["normal"].dtype == np.float64
    assert pile.unit("normal") == "chi g B" and pile.unit("x_over_b") == "1"
    assert pile.model.value("slope_deg") == "45"
    with pytest.raises(KeyError):
        pile["horizontal"]


def test_a_number_keeps_its_bits():
    slope = 30.0 + 2.0**-45
    assert float(theory.predict("pile-continuum", slope_deg=slope).model.value("slope_deg")) == slope
    assert theory.predict("pile-continuum", points=np.int64(5))["normal"].shape == (5,)


def test_errors_are_value_errors():
    with pytest.raises(ValueError, match="slope_deg = 60.0: must be > 0 and < 60"):
        theory.predict("pile-continuum", slope_deg=60.0)
    with pytest.raises(theory.InputError, match="no such model of theory"):
        theory.predict("pyramid")


def test_every_model_has_a_picture():
    assert set(MODEL_PICTURES) == set(theory.models())


@pytest.mark.parametrize("module", ["repose", "repose.theory"])
def test_reading_and_predicting_need_no_matplotlib(module):
    code = f"import sys, {module}; sys.exit('matplotlib' in sys.modules)"
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
    assert subprocess.run([sys.executable, "-c", code], env=environment, check=False).returncode == 0


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("kind", ["pdf", "eps"])
@pytest.mark.parametrize("model", [name for name in theory.models() if name != "janssen-fit"])
def test_every_model_is_printed(tmp_path, caplog, model, kind):
    """Matplotlib logs a warning where EPS would need transparency, which it lacks."""
    picture = tmp_path / f"model.{kind}"
    status = draw_theory.main([model, "--plot", str(picture)])
    assert status == 0 and picture.stat().st_size > 1000
    assert not caplog.records


def test_draws_a_model_into_a_file(tmp_path, capsys):
    picture = tmp_path / "pile.png"
    assert draw_theory.main(["pile-continuum", "--set", "slope_deg=20", "--plot", str(picture), "--dpi", "50"]) == 0
    assert picture.read_bytes().startswith(b"\x89PNG") and [picture] == list(tmp_path.iterdir())
    assert capsys.readouterr() == ("", "")


@pytest.mark.parametrize(
    "words, message",
    [
        (["pyramid"], "pyramid: no such model of theory; must be "),
        (["pile-continuum", "--set", "slope_deg=70"], "pile-continuum: slope_deg = 70: must be > 0 and < 60"),
    ],
)
def test_wrong_models_and_parameters_are_reported(tmp_path, capsys, words, message):
    assert draw_theory.main([*words, "--plot", str(tmp_path / "x.png")]) == 2
    printed = capsys.readouterr()
    assert printed.err.startswith(message) and printed.out == "" and not list(tmp_path.iterdir())


def test_a_picture_that_cannot_be_written_is_reported(tmp_path, capsys):
    assert draw_theory.main(["pile-continuum", "--plot", str(tmp_path / "nowhere" / "x.png")]) == 2
    assert capsys.readouterr().err.endswith(": cannot be written: No such file or directory\n")
