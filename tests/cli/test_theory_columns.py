# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Models of columns, local stress and packings through the program: numbers from other derivations, and refused input."""

import csv
import math
from pathlib import Path

import numpy as np
import pytest
from conftest import repose

COLUMN = Path(__file__).resolve().parents[2] / "examples" / "data" / "column.csv"


def asked(model, **settings):
    """(columns, results) of a model: lists of numbers or words, and numbers by name."""
    out = repose("theory", model, *(word for key, value in settings.items() for word in ("--set", f"{key}={value}")))
    assert out.returncode == 0 and not out.stderr, out.stderr
    lines = out.stdout.splitlines()
    names, *rows = csv.reader(line for line in lines if not line.startswith("#"))
    columns = {name: [_value(cell) for cell in cells] for name, *cells in zip(names, *rows)}
    results = {
        line.split()[2]: float(line.split("=", 1)[1].split(":")[0].split("[")[0])
        for line in lines
        if line.startswith("# result ")
    }
    return columns, results


def _value(cell):
    try:
        return float(cell)
    except ValueError:
        return cell


def test_janssen():
    settings = {"width": 0.3, "stress_ratio": 0.4, "friction": 0.5, "solid_fraction": 0.6, "density": 2500}
    settings |= {"gravity": 9.81, "height": 2, "points": 5, "overload": 300}
    for dimension, walls, area in ((2, 2, 0.3), (3, 4, math.pi * 0.15**2)):
        for direction, sense in (("rest", 1), ("pushed-up", -1)):
            columns, results = asked("janssen", dimension=dimension, direction=direction, **settings)
            assert list(columns) == ["depth", "stress", "apparent_mass"]
            length = 0.3 / (walls * 0.4 * 0.5)
            assert results["lambda"] == pytest.approx(length, rel=1e-15)
            depth = np.array(columns["depth"])
            assert depth == pytest.approx(np.linspace(0, 2, 5), abs=1e-15)
            decay = np.exp(-sense * depth / length)
            stress = sense * 2500 * 0.6 * 9.81 * length * (1 - decay) + 300 * decay
            assert columns["stress"] == pytest.approx(stress, rel=1e-13)
            assert columns["apparent_mass"] == pytest.approx(stress * area / 9.81, rel=1e-13)
            saturation = 2500 * 0.6 * area * length if sense > 0 else math.inf
            assert results["saturation_mass"] == pytest.approx(saturation, rel=1e-13)


def test_janssen_discrete():
    for direction, sign, ratio in (("rest", 1, 0.91161), ("pushed-up", -1, 1.11572)):
        columns, results = asked("janssen-discrete", k_mu=0.1, layers=12, direction=direction)
        force, expected = 0.0, []
        for _ in range(12):
            force = (force + 3) / (1 + sign * 0.2)
            expected.append(force)
        assert columns["layer"] == list(range(1, 13))
        assert columns["force"] == pytest.approx(expected, rel=1e-13)
        assert results["ratio"] == pytest.approx(ratio, abs=5e-6)
        assert results["lambda_1"] / results["lambda_2"] == pytest.approx(results["ratio"], rel=1e-14)
    assert asked("janssen-discrete", k_mu=0, layers=4)[0]["force"] == [3, 6, 9, 12]


def test_fit_of_the_discrete_model(tmp_path):
    """The table of the discrete model with changed names, and with a column that the fit ignores."""
    for direction, ratio in (("rest", 0.91161), ("pushed-up", 1.11572)):
        text = repose("theory", "janssen-discrete", "--set", f"direction={direction}").stdout
        lines = text.replace("layer,force", "height,apparent_mass").splitlines()
        head = lines.index("height,apparent_mass")
        lines[head:] = [lines[head] + ",note", *(line + ",none" for line in lines[head + 1 :])]
        file = tmp_path / "column.csv"
        file.write_text("\n".join(lines) + "\n")
        columns, results = asked("janssen-fit", file=file, direction=direction, mass_per_height=3)
        assert list(columns) == ["height", "apparent_mass", "fitted", "residual"]
        assert results["ratio"] == pytest.approx(ratio, abs=5e-6)
        assert results["degrees_of_freedom"] == 18
        assert columns["fitted"] == pytest.approx(columns["apparent_mass"], rel=1e-12)


def test_fit_of_the_example():
    """One length does not describe the cells, two lengths do, and the true lengths lie within two errors."""
    _, two = asked("janssen-fit", file=COLUMN, mass_per_height=3)
    _, one = asked("janssen-fit", file=COLUMN, mass_per_height=3, parameters=1)
    assert abs(two["lambda_1"] - 5) < 2 * two["lambda_1_error"]
    assert abs(two["lambda_2"] - 1 / math.log(1.2)) < 2 * two["lambda_2_error"]
    assert one["lambda_1"] == one["lambda_2"] and one["degrees_of_freedom"] == 14
    assert one["chance"] < 0.01 < 0.5 < two["chance"]


def test_mohr():
    columns, results = asked("mohr", s_xx=0.7, s_zz=1.9, s_xz=-0.45, plane_deg=25, friction_deg=20, points=7)
    tensor = np.array([[0.7, -0.45], [-0.45, 1.9]])
    angles = np.radians(columns["plane_deg"])
    assert columns["plane_deg"] == pytest.approx([-90, -60, -30, 0, 30, 60, 90])
    along = np.array([np.cos(angles), np.sin(angles)])
    across = np.array([-along[1], along[0]])
    assert columns["normal"] == pytest.approx(np.einsum("in,ij,jn->n", across, tensor, across), rel=1e-13)
    assert columns["shear"] == pytest.approx(np.einsum("in,ij,jn->n", along, tensor, across), rel=1e-13)
    values, vectors = np.linalg.eigh(tensor)
    assert [results["minor"], results["major"]] == pytest.approx(values, rel=1e-14)
    right, down = vectors[:, 1] * np.sign(vectors[1, 1])
    assert results["principal_angle_deg"] == pytest.approx(math.degrees(math.atan2(right, down)), rel=1e-13)
    ratio = (values[1] - values[0]) / (values[1] + values[0]) / math.sin(math.radians(20))
    assert results["coulomb_ratio"] == pytest.approx(ratio, rel=1e-13)
    assert results["yields"] == (1 if ratio > 1 else 0) == 1


def test_quasi_elastic():
    assert asked("quasi-elastic", poisson_ratio=0.25)[0] == {"poisson_ratio": [0.25], "stress_ratio": [pytest.approx(1 / 3)]}


def test_packing():
    columns, results = asked("packing")
    assert list(columns) == ["name", "dimension", "solid_fraction", "error", "coordination", "source"]
    known = dict(zip(zip(columns["name"], columns["dimension"]), columns["solid_fraction"]))
    assert known["hexagonal", 2] == pytest.approx(math.pi / math.sqrt(12), rel=1e-15)
    assert known["face-centred cubic", 3] == known["hexagonal close", 3] == pytest.approx(math.pi / math.sqrt(18))
    assert results["fabric_trace"] == 1 and results["anisotropy_bound"] == 2
    assert set(asked("packing", dimension=2)[0]["dimension"]) == {2.0}


def refused(model, *settings):
    out = repose("theory", model, *(word for setting in settings for word in ("--set", setting)))
    assert out.returncode == 2 and out.stdout == "", out.stdout
    lines = out.stderr.splitlines()
    assert len(lines) == 1, lines
    return lines[0]


@pytest.mark.parametrize(
    "model, settings, complaint",
    [
        ("janssen", ["width=-1"], "janssen: width = -1: must be > 0 (L)"),
        ("janssen", ["solid_fraction=1.1"], "janssen: solid_fraction = 1.1: must be > 0 and <= 1"),
        ("janssen", ["dimension=4"], "janssen: dimension = 4: must be from 2 to 3"),
        ("janssen", ["friction=-0.1"], "janssen: friction = -0.1: must be >= 0"),
        ("janssen", ["direction=down"], "janssen: direction = down: must be rest | pushed-up"),
        ("janssen", ["direction=pushed-up", "height=701"], "janssen: height = 701: is 701 screening lengths (1); must be <= 700"),
        ("janssen-discrete", ["direction=pushed-up", "k_mu=0.5"], "janssen-discrete: k_mu = 0.5: must be < 0.5 with direction = pushed-up"),
        ("janssen-discrete", ["direction=pushed-up", "layers=5000"], "janssen-discrete: layers = 5000: is 1115.72 times lambda_2"),
        ("janssen-discrete", ["layers=0"], "janssen-discrete: layers = 0: must be from 1 to"),
        ("janssen-fit", ["file=none.csv", "mass_per_height=1"], "none.csv: no such file"),
        ("janssen-fit", [f"file={COLUMN}"], "janssen-fit: mass_per_height: must be given"),
        ("janssen-fit", ["mass_per_height=1"], "janssen-fit: file: must be given"),
        ("janssen-fit", ["file=.", "mass_per_height=1"], ".: is a folder"),
        ("mohr", ["friction_deg=90"], "mohr: friction_deg = 90: must be >= 0 and < 90 (deg)"),
        ("mohr", ["plane_deg=100"], "mohr: plane_deg = 100: must be >= -90 and <= 90 (deg)"),
        ("quasi-elastic", ["poisson_ratio=-1"], "quasi-elastic: poisson_ratio = -1: must be > -1 and <= 0.5"),
        ("packing", ["dimension=4"], "packing: dimension = 4: must be all | 2 | 3"),
    ],
)
def test_refusals(model, settings, complaint):
    assert refused(model, *settings).startswith(complaint)


@pytest.mark.parametrize(
    "text, complaint",
    [
        ("height,mass\n1,2\n", ": has no column apparent_mass; has height, mass"),
        ("# masses\nheight,apparent_mass\n1,2\n2,x\n", ":4: apparent_mass = x: is not a finite number"),
        ("height,apparent_mass\n1,2\n-2,3\n", ":3: height = -2: must be >= 0 (L)"),
        ("height,apparent_mass,apparent_mass_error\n1,2,1\n2,3,0\n", ":3: apparent_mass_error = 0: must be > 0 (M)"),
        ("height,apparent_mass\n1,2\n2\n", ":3: has 1 value; must have 2"),
        ("height,apparent_mass\n1,2\n", ": has 1 row; 2 parameters need as many"),
        ("", ": is empty: no line with the names of the columns"),
        ("height,apparent_mass\n1,1\n2,2\n3,3\n", "janssen-fit: the data do not determine lambda_2: a straight line"),
    ],
)
def test_refused_files(tmp_path, text, complaint):
    file = tmp_path / "column.csv"
    file.write_text(text)
    line = refused("janssen-fit", f"file={file}", "mass_per_height=1")
    assert line.removeprefix(str(file)).startswith(complaint), line


def test_pictures_of_limiting_cases(tmp_path):
    """A picture without warnings if a curve is a point, a limit is infinite, or a dimension is left out."""
    corners = [
        ("janssen", ["friction=0"]),
        ("janssen", ["direction=pushed-up", "dimension=2", "overload=2"]),
        ("janssen-discrete", ["k_mu=0", "layers=1"]),
        ("janssen-discrete", ["direction=pushed-up", "layers=200"]),
        ("janssen-fit", [f"file={COLUMN}", "mass_per_height=3", "parameters=1"]),
        ("mohr", ["s_xx=0", "s_zz=0", "s_xz=0"]),
        ("mohr", ["s_xx=-1", "s_zz=-1", "s_xz=0", "friction_deg=0"]),
        ("quasi-elastic", ["poisson_ratio=-0.9"]),
        ("packing", ["dimension=3"]),
    ]
    for number, (model, settings) in enumerate(corners):
        file = tmp_path / f"{number}.png"
        words = [word for setting in settings for word in ("--set", setting)]
        out = repose("theory", model, *words, "--plot", file)
        assert out.returncode == 0 and out.stdout == out.stderr == "", (model, settings, out.stderr)
        assert file.read_bytes().startswith(b"\x89PNG")
