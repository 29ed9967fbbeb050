# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The q-model, and the response to a point load in theory and simulation, through the program."""

import csv
import io
import json
import math

import h5py
import numpy as np
import pytest
from conftest import repose

# Equal discs in the hollows of a base row: 6 rows, with gaps so that discs of a row do not touch.
LATTICE = """[contact]
friction = 0.0
normal = { law = "hooke", stiffness = 1e5, damping = 0.5 }
[base]
kind = "row"
spacing = 1.02
half_width = 10.2
[box]
x = "periodic"
[source]
kind = "lattice"
rows = 6
columns = 20
[[load]]
position = [0.0, 20.0]
force = [0.0, -1.0]
start = 15.0
[stop]
time = 35.0
[output]
window = 5.0
"""
FRICTION = 'contact.friction = 0.5, contact.tangential = { law = "linear", stiffness = 5e4, damping = 0.1 }'
SWEEP = f"""scene = "lattice.toml"
seeds = 2
[[point]]
name = "bare"
set = {{ load = [] }}
[[point]]
name = "loaded"
[[point]]
name = "doubled"
set = {{ load = [{{ position = [0.0, 20.0], force = [0.0, -2.0], start = 15.0 }}] }}
[[point]]
name = "rough-bare"
set = {{ load = [], {FRICTION} }}
[[point]]
name = "rough-loaded"
set = {{ {FRICTION} }}
"""
H = 6 * math.sqrt(1.0 - 0.51**2)  # height of the loaded disc above the base centres, without overlaps


def table_of(text):
    rows = list(csv.DictReader(line for line in io.StringIO(text) if not line.startswith("#")))
    return {name: np.array([float(row[name]) for row in rows]) for name in rows[0]}


def theory(model, **settings):
    words = [word for name, value in settings.items() for word in ("--set", f"{name}={value}")]
    result = repose("theory", model, *words)
    assert result.returncode == 0, result.stderr
    return table_of(result.stdout)


@pytest.fixture(scope="module")
def lattice(tmp_path_factory):
    folder = tmp_path_factory.mktemp("lattice")
    (folder / "lattice.toml").write_text(LATTICE)
    (folder / "sweep.toml").write_text(SWEEP)
    result = repose("sweep", "sweep.toml", "--out", "out", "--quiet", cwd=folder)
    assert result.returncode == 0, result.stderr
    return folder / "out"


def base_of(folder, point, seed=1):
    with h5py.File(folder / "members" / point / f"seed-{seed}" / "run.h5") as file:
        return file["base/x"][()], file["base/normal"][()]


def test_a_lattice_without_friction_carries_a_load_down_two_rays(lattice):
    x, without = base_of(lattice, "bare")
    more = base_of(lattice, "loaded")[1] - without
    assert more.sum() == pytest.approx(1.0, abs=1e-6)
    rays = np.isclose(np.abs(x), 3 * 1.02)  # six rows of half a spacing
    assert rays.sum() == 2
    # Each ray carries half of the load, and nothing is carried elsewhere, up to effects of the overlaps (6e-5 at the
    # floor) of at most about 2 %.
    assert more[rays] == pytest.approx(0.5, abs=0.01)
    assert np.abs(more[~rays]).max() < 0.01


def test_friction_makes_one_peak_of_the_two_rays(lattice):
    x, without = base_of(lattice, "rough-bare")
    more = base_of(lattice, "rough-loaded")[1] - without
    assert more.sum() == pytest.approx(1.0, abs=1e-6)
    assert abs(x[np.argmax(more)]) < 0.6
    assert more[np.abs(x) < 0.6].mean() > 2.0 * more[np.isclose(np.abs(x), 3 * 1.02)].mean()


def test_the_response_of_a_sweep_is_the_paired_difference(lattice):
    rows = list(csv.DictReader((lattice / "response.csv").open()))
    facts = {one["point"]: one for one in json.loads((lattice / "response.json").read_text())}
    assert list(facts) == ["loaded", "doubled", "rough-loaded"]
    assert facts["rough-loaded"]["without"] == "rough-bare"
    for point, force in (("loaded", 1.0), ("doubled", 2.0)):
        one = facts[point]
        assert one["force"] == force and one["seeds"] == 2 and one["places"] == 1
        assert one["depth"]["mean"] == pytest.approx(H, rel=1e-3) and one["depth"]["error"] == 0.0
        assert one["total"]["mean"] == pytest.approx(1.0, abs=1e-6)
        assert one["eta"] == pytest.approx(0.51**2 / (1.0 - 0.51**2), rel=1e-12)
        h, width = one["depth"]["mean"], one["bin"]
        assert width == pytest.approx(1.02 / h, rel=1e-12)  # a pitch, which is more than a tenth of h
        x, without = base_of(lattice, "bare")
        more = base_of(lattice, point)[1] - without
        for row in (row for row in rows if row["point"] == point):
            disc = np.argmin(np.abs(x - float(row["x_over_h"]) * h))
            assert float(row["response"]) == pytest.approx(more[disc] * h / 1.02 / force, abs=1e-9)
    loaded, doubled = (np.array([float(r["response"]) for r in rows if r["point"] == p]) for p in ("loaded", "doubled"))
    assert np.abs(loaded - doubled).max() < 0.01 * loaded.max()  # a small load: the response is linear


def test_the_response_beside_theory(lattice):
    rows = [row for row in csv.DictReader((lattice / "response.csv").open()) if row["point"] == "loaded"]
    facts = json.loads((lattice / "response.json").read_text())[0]
    curve = theory(
        "point-load",
        floor="rough-rigid",
        poisson=0.25,  # no tangential springs
        eta=facts["eta"],
        load_width=facts["bin"],
        half_range=2.5,
        points=20001,
    )
    for name, tolerance in (("elastic", 1e-3), ("osl", 2e-2)):
        for row in rows:
            inside = np.abs(curve["x_over_h"] - float(row["x_over_h"])) < 0.5 * facts["bin"]
            assert float(row[name]) == pytest.approx(curve[name][inside].mean(), abs=tolerance), name
    # The rays of OSL are those of the simulation.
    osl = np.array([float(row["osl"]) for row in rows])
    response = np.array([float(row["response"]) for row in rows])
    assert np.abs(osl - response).max() < 0.03 * osl.max()
    picture = repose("plot", lattice, "--only", "response", "--format", "png")
    assert picture.returncode == 0 and (lattice / "pictures" / "response.png").is_file(), picture.stdout


def test_q_model_variance_and_conservation_through_the_program():
    for edges in ("periodic", "walls"):
        table = theory("q-model", output="variance", width=40, layers=60, runs=400, edges=edges, seed=5)
        off = np.abs(table["variance"] - table["exact"])[1:] / table["variance_error"][1:]
        assert off.max() < 4.0 and off.max() > 0.2
    # The second layer by hand: two fractions of one grain each, variance 2/12 over the mean^2 of 4.
    table = theory("q-model", output="variance", width=10, layers=2)
    assert table["exact"] == pytest.approx([0.0, 2.0 / 12.0 / 4.0], abs=1e-15)
    table = theory("q-model", bins=100, largest=20, runs=5)
    assert table["density"].sum() * 0.2 == pytest.approx(1.0, abs=1e-12)
    assert table["exact"] == pytest.approx(4 * table["weight"] * np.exp(-2 * table["weight"]), rel=1e-12)


def test_point_load_through_the_program():
    table = theory("point-load", load_width=0, half_range=3, points=601)
    x = table["x_over_h"]
    assert "osl" not in table
    assert table["elastic"] == pytest.approx(2 / (math.pi * (1 + x * x) ** 2), rel=1e-13)
    for floor in ("smooth-rigid", "rough-rigid"):
        table = theory("point-load", load_width=0.25, floor=floor, half_range=8, points=3201, eta=0.5, mu=0.3)
        for name in ("elastic", "osl", "diffusive"):
            assert table[name].sum() * 0.005 == pytest.approx(1.0, abs=2e-5), name
            assert (table[name] * table["x_over_h"]).sum() * 0.005 == pytest.approx(0.0, abs=0.003), name


def test_bad_settings_are_refused_in_one_message():
    for model, setting, part in (
        ("q-model", "injection=0", "needs start = gamma"),
        ("q-model", "width=1", "must be from 2"),
        ("q-model", "runs=1", "must be from 2"),
        ("point-load", "eta=0", "must be > 0"),
        ("point-load", "poisson=0.6", "must be >= 0 and <= 0.5"),
    ):
        result = repose("theory", model, "--set", setting)
        assert result.returncode == 2 and part in result.stderr and result.stdout == "", result.stderr
