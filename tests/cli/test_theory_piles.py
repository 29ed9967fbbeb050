# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Base stresses under piles through the program: tables, their integrals, refused input, pictures."""

import numpy as np
import pytest


def table(lab, model, *settings):
    """The columns and numbers that `repose theory` prints."""
    result = lab("theory", model, *(word for setting in settings for word in ("--set", setting)), "--csv", "-")
    assert result.returncode == 0, result.stderr
    lines = result.stdout.splitlines()
    numbers = {}
    for line in lines:
        if line.startswith("# result "):
            name, value = line[len("# result ") :].split(" = ", 1)
            numbers[name] = float(value.split(" ")[0].rstrip(":"))
    rows = [line for line in lines if not line.startswith("#")]
    values = np.array([row.split(",") for row in rows[1:]], dtype=float)
    return dict(zip(rows[0].split(","), values.T)), numbers


@pytest.mark.parametrize(
    "settings, discs",
    [
        (("slope_deg=30", "base_count=45"), 360),
        (("slope_deg=30", "base_count=180"), 5490),
        (("slope_deg=60", "base_count=44"), 990),
    ],
)
def test_lattice_pile_carries_the_weight_of_its_discs(lab, settings, discs):
    columns, numbers = table(lab, "pile-lattice", *settings)
    assert list(columns) == ["x_over_b", "normal", "shear"]
    assert numbers["discs"] == numbers["weight"] == discs
    assert columns["normal"].sum() == discs
    assert columns["shear"].sum() == pytest.approx(0.0, abs=1e-10)
    assert columns["shear"][0] <= 0.0 <= columns["shear"][-1]  # outward


@pytest.mark.parametrize(
    "model, settings",
    [("pile-continuum", ("slope_deg=37.7",)), ("pile-tent", ()), ("pile-tent", ("upper_slope_deg=12", "break_at=0.2"))],
)
def test_continuum_piles_carry_the_weight_of_their_area(lab, model, settings):
    columns, numbers = table(lab, model, *settings, "points=100001")
    assert list(columns) == ["x_over_b", "normal", "shear"]
    assert columns["normal"].sum() / 100000 == pytest.approx(numbers["weight"], rel=1e-8)  # trapezia across kinks
    assert (columns["x_over_b"][0], columns["x_over_b"][-1]) == (0.0, 1.0)


def test_tent_of_the_paper_dips(lab):
    columns, numbers = table(lab, "pile-tent", "lower_slope_deg=30", "upper_slope_deg=45", "break_at=0.38")
    assert numbers["dip"] == 1
    assert numbers["dip_depth"] == pytest.approx(0.081, abs=0.0005)
    assert 1.0 - columns["normal"][100] / columns["normal"].max() == pytest.approx(0.081, abs=0.001)


@pytest.mark.parametrize("model", ["fpa", "bcc", "ife"])
def test_osl_base_carries_the_weight_of_the_pile(lab, model):
    columns, numbers = table(lab, "osl", f"model={model}", "angle_deg=33.3", "points=100001")
    assert list(columns) == ["x_over_b", "normal", "shear", "horizontal", "yield_margin"]
    width = 2.0 / np.tan(np.radians(33.3))
    assert columns["normal"].sum() / 100000 * width == pytest.approx(0.5 * width, rel=1e-8)
    assert numbers["weight"] == pytest.approx(0.5 * width, rel=1e-14)
    assert numbers["dip"] == (1 if model == "fpa" else 0)
    assert columns["yield_margin"].min() > -1e-12
    assert (columns["shear"][:50000] <= 0.0).all() and (columns["shear"][50000:] >= 0.0).all()


def test_osl_with_the_closure_of_the_lattice_is_the_continuum_pile(lab):
    settings = ("model=custom", "mu=0", f"eta={1 / 3!r}", "slope_deg=25", "angle_deg=44")
    wedge, _ = table(lab, "osl", *settings)
    pile, _ = table(lab, "pile-continuum", "slope_deg=25")
    unit = np.sqrt(3.0) / np.tan(np.radians(25.0))  # sqrt(3)/2 for rho, B/h = 2/tan(slope)
    for name in ("normal", "shear"):
        np.testing.assert_allclose(wedge[name], unit * pile[name], rtol=1e-12, atol=1e-15)


def test_osl_field_is_in_equilibrium(lab):
    columns, _ = table(lab, "osl", "model=ife", "angle_deg=28", "output=field", "grid=200")
    assert list(columns) == ["x_over_h", "z_over_h", "normal", "shear", "horizontal", "yield_margin"]
    foot = 1.0 / np.tan(np.radians(28.0))
    assert len(columns["x_over_h"]) == 200 * 202
    assert (np.abs(columns["x_over_h"]) <= columns["z_over_h"] * foot * (1 + 1e-14)).all()
    field = {}
    row = np.rint(columns["z_over_h"] * 200).astype(int)
    place = np.rint(columns["x_over_h"] * 200 / foot).astype(int)
    for name in ("normal", "shear", "horizontal"):
        field[name] = np.zeros((201, 401))
        field[name][row, 200 + place] = columns[name]

    def change(name, axis, step):
        f = np.roll
        a = field[name]
        return (8 * (f(a, -1, axis) - f(a, 1, axis)) - f(a, -2, axis) + f(a, 2, axis)) / (12 * step)

    across = change("horizontal", 1, foot / 200) + change("shear", 0, 1 / 200)
    down = change("shear", 1, foot / 200) + change("normal", 0, 1 / 200) - 1.0
    inside = np.zeros_like(down, dtype=bool)
    for i in range(140, 199):
        inside[i, 200 - (i - 4) : 200 + (i - 4) + 1] = True
    assert np.abs(across[inside]).max() < 1e-6
    assert np.abs(down[inside]).max() < 1e-6


@pytest.mark.parametrize(
    "model, settings, message",
    [
        ("pile-continuum", ("slope_deg=61",), "slope_deg = 61: must be > 0 and < 60 (deg)"),
        ("pile-continuum", ("slope_deg=60",), "slope_deg = 60: must be > 0 and < 60 (deg)"),
        ("pile-lattice", ("slope_deg=61",), "slope_deg = 61: must be > 0 and <= 60 (deg)"),
        ("pile-lattice", ("slope_deg=0",), "slope_deg = 0: must be > 0 and <= 60 (deg)"),
        ("pile-lattice", ("base_count=1",), "base_count = 1: must be from 2 to 1000000"),
        ("pile-tent", ("upper_slope_deg=60",), "upper_slope_deg = 60: must be > 0 and < 60 (deg)"),
        ("pile-tent", ("break_at=0.51",), "break_at = 0.51: must be > 0 and <= 0.5 (B)"),
        ("osl", ("model=arch",), "model = arch: must be fpa | bcc | ife | custom"),
        ("osl", ("slope_deg=31",), "slope_deg = 31: must be <= angle_deg = 30"),
        ("osl", ("eta=1",), "eta = 1: only for model = custom"),
        ("osl", ("model=custom", "eta=1"), "mu: must be given with model = custom"),
        ("osl", ("model=custom", "mu=0", "eta=-1"), "eta = -1: must be > 0"),
        ("osl", ("model=custom", "mu=3", "eta=1"), "mu = 3, eta = 1: 1 - mu T - eta T^2 = -1.06538 must be > 0"),
        ("osl", ("model=ife", "slope_deg=20"), "slope_deg = 20: must be angle_deg = 30 with model = ife"),
    ],
)
def test_refused_in_one_line(lab, model, settings, message):
    words = [word for setting in settings for word in ("--set", setting)]
    error = lab.refused("theory", model, *words, "--csv", "out.csv", parts=(f"{model}: {message}",))
    assert len(error.splitlines()) == 1


@pytest.mark.parametrize(
    "model, settings, file, start",
    [
        ("pile-lattice", (), "lattice.png", b"\x89PNG"),
        ("pile-tent", ("points=31",), "tent.svg", b"<?xml"),
        ("osl", ("model=ife",), "ife.png", b"\x89PNG"),
        ("osl", ("output=field", "grid=20"), "field.svg", b"<?xml"),
    ],
)
def test_pictures(lab, model, settings, file, start):
    words = [word for setting in settings for word in ("--set", setting)]
    result = lab("theory", model, *words, "--plot", file)
    assert result.returncode == 0, result.stderr
    assert (lab.path / file).read_bytes().startswith(start)
