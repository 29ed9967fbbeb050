# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""`repose plot DIR --theory`: its numbers, computed again with numpy from the files of the run and the model's table."""

import csv
import io
import json
import re
import shutil
import signal
import subprocess
import time

import h5py
import numpy as np
import pytest
import xxhash
from conftest import HEAP, LIMIT, PROGRAM, changed, repose, summary

POURED = (
    HEAP.replace("count = 40", "count = 150")
    .replace("half_width = 8", "half_width = 25")
    .replace("height = 10", "height = 15")
)
SWEEP = """title = "friction"
scene = "heap.toml"
seeds = 3
[vary]
contact.friction = [0.2, 0.5]
"""
QUICK = ("--only", "theory", "--format", "png", "--dpi", "50")
CONTINUUM = ("--theory", "pile-continuum")


@pytest.fixture(scope="module")
def poured(tmp_path_factory):
    """A heap of 150 grains at rest, and its summary as written. Tests copy it."""
    folder = tmp_path_factory.mktemp("poured")
    (folder / "scene.toml").write_text(POURED)
    subprocess.run([PROGRAM, "run", "scene.toml", "--out", "out", "--quiet"], cwd=folder, check=True, timeout=LIMIT)
    return folder / "out"


@pytest.fixture
def out(lab, poured):
    shutil.copytree(poured, lab.path / "out")
    return lab.path / "out"


@pytest.fixture(scope="module")
def swept(tmp_path_factory):
    """A finished sweep of six heaps. Tests copy it."""
    folder = tmp_path_factory.mktemp("swept")
    (folder / "heap.toml").write_text(HEAP)
    (folder / "sweep.toml").write_text(SWEEP)
    subprocess.run([PROGRAM, "sweep", "sweep.toml", "--out", "out"], cwd=folder, check=True, timeout=LIMIT, stdout=-3)
    return folder / "out"


def table_of(model, parameters):
    """Columns of `repose theory` by name."""
    written = {key: value if isinstance(value, str) else repr(value) for key, value in parameters.items()}
    settings = [word for key, value in written.items() if value != "None" for word in ("--set", f"{key}={value}")]
    printed = repose("theory", model, *settings, "--csv", "-")
    assert printed.returncode == 0, printed.stderr
    rows = csv.DictReader(io.StringIO(re.sub(r"^#.*\n", "", printed.stdout, flags=re.M)))
    rows = list(rows)
    return {name: np.array([float(row[name]) for row in rows]) for name in ("x_over_b", "normal", "shear")}


def area(y, x):
    """The area under straight lines."""
    return (0.5 * (y[1:] + y[:-1]) * np.diff(x)).sum()


def compared(table, x, bins, centre, half_width):
    """The bins, width and weight of a model, by quadrature in many small steps."""
    fine = np.linspace(0.0, 1.0, 1_000_001)
    above = fine[np.interp(fine, table["x_over_b"], table["normal"]) > 0.1 * table["normal"].max()]
    width = 2.0 * half_width / (above[-1] - above[0])
    left = centre - 0.5 * (above[-1] + above[0]) * width
    ends = np.concatenate([[x[0] - 0.5 * (x[1] - x[0])], 0.5 * (x[1:] + x[:-1]), [x[-1] + 0.5 * (x[-1] - x[-2])]])
    steps = (np.arange(4000) + 0.5) / 4000
    places = (ends[:-1, None] + np.diff(ends)[:, None] * steps - left) / width
    total = area(table["normal"], table["x_over_b"])
    number = np.floor(x / bins["width"] + 0.5)
    forces = {}
    for name in ("normal", "shear"):
        density = np.interp(places, table["x_over_b"], table[name], left=0.0, right=0.0)
        disc = density.mean(axis=1) * np.diff(ends) / (width * total) * bins["weight"]
        forces[name] = np.array([disc[number == round(at / bins["width"])].mean() for at in bins["x"]])
    return forces, width, left


def check_entry(entry, x, bins, centre, half_width):
    """Checks an entry of the summary against measured bins (x, normal, shear, errors, width, weight)."""
    table = table_of(entry["model"], entry["parameters"])
    forces, width, left = compared(table, x, bins, centre, half_width)
    base = entry["base"]
    assert entry["weight"] == pytest.approx(bins["weight"], rel=1e-12)
    assert base["width"] == pytest.approx(width, rel=1e-5)  # steps of 1e-6 on either side
    assert base["left"] == pytest.approx(left, abs=1e-5 * width)
    assert base["centre"] == pytest.approx(left + 0.5 * width, abs=1e-5 * width)
    loaded = np.abs(bins["x"] - centre) <= half_width
    residuals = entry["residuals"]
    np.testing.assert_array_equal(residuals["x"], bins["x"][loaded])
    mean = bins["normal"][loaded].mean()
    for name, matched in (("normal", 3), ("shear", 0)):
        expected = (bins[name] - forces[name])[loaded]
        error = bins[f"{name}_error"][loaded]
        np.testing.assert_allclose(residuals[name], expected, atol=1e-4 * mean)
        np.testing.assert_array_equal(np.array(residuals[f"{name}_error"], dtype=float), error)
        counts = error > 0.0
        own = entry[name]
        assert own["bins"] == counts.sum() and own["degrees"] == max(0, counts.sum() - matched)
        if own["degrees"]:
            chi = ((np.array(residuals[name]) / error)[counts] ** 2).sum()
            assert own["chi_square"] == pytest.approx(chi, rel=1e-12)
        else:
            assert own["chi_square"] is None
        assert own["rms"] == pytest.approx(np.sqrt((expected**2).mean()), abs=1e-4 * mean)
        assert own["rms_over_mean"] == pytest.approx(own["rms"] / mean, rel=1e-12)
    return table


def bins_of(group, x_weight):
    columns = {name: group[name][()] for name in ("x", "normal", "shear", "normal_error", "shear_error")}
    return {**columns, "width": group.attrs["bin_width"], "weight": x_weight}


def test_numbers_of_a_run(lab, out):
    result = lab("plot", "out", *CONTINUUM, "--theory", "pile-continuum:slope_deg=20,points=41", *QUICK)
    assert result.returncode == 0, result.stderr
    numbers = summary(out)
    first, second = numbers["theory"]
    slope = numbers["angle_of_repose_deg"]["mean"]
    assert first["parameters"] == {"slope_deg": slope, "points": 201} and first["from_run"] == ["slope_deg"]
    assert second["parameters"] == {"slope_deg": 20, "points": 41} and second["from_run"] == []
    assert "point" not in first
    with h5py.File(out / "run.h5", "r") as file:
        x, weight = file["base/x"][()], file["base/normal"][()].sum()
        bins = bins_of(file["analysis/base"], weight)
    dip = numbers["base_dip"]
    for entry in numbers["theory"]:
        table = check_entry(entry, x, bins, dip["centre"], dip["half_width"])
        # The integral of a curve in a picture is the whole weight.
        carried = area(entry["scale"] * table["normal"], table["x_over_b"])
        assert carried * entry["base"]["width"] / entry["base"]["spacing"] == pytest.approx(weight, rel=1e-12)
    printed = [line for line in result.stdout.splitlines() if "chi-square per degree" in line]
    assert len(printed) == 4
    expected = first["normal"]["chi_square"] / first["normal"]["degrees"]
    assert float(re.search(r"per degree ([0-9.e+-]+)", printed[0])[1]) == pytest.approx(expected, rel=1e-3)
    assert (out / "pictures/theory.png").is_file()


@pytest.mark.parametrize(
    "choice, parameters, from_run",
    [
        (
            "osl:model=fpa",
            {"model": "fpa", "angle_deg": "slope", "slope_deg": None, "mu": None, "eta": None},
            ["angle_deg"],
        ),
        ("osl:model=ife,points=1001", {"model": "ife", "points": 1001}, ["angle_deg"]),
        (
            "osl:model=custom,mu=-0.1,eta=0.5,angle_deg=50",
            {"mu": -0.1, "eta": 0.5, "angle_deg": 50, "slope_deg": "slope"},
            ["slope_deg"],
        ),
        ("pile-lattice", {"slope_deg": "slope"}, ["slope_deg", "base_count"]),
        ("pile-tent:upper_slope_deg=40", {"lower_slope_deg": 30, "upper_slope_deg": 40}, []),
    ],
)
def test_models_of_every_kind(lab, out, choice, parameters, from_run):
    result = lab("plot", "out", "--theory", choice, *QUICK)
    assert result.returncode == 0 and "not drawn" not in result.stdout, result.stdout + result.stderr
    numbers = summary(out)
    (entry,) = numbers["theory"]
    slope = numbers["angle_of_repose_deg"]["mean"]
    expected = {name: slope if value == "slope" else value for name, value in parameters.items()}
    assert {name: entry["parameters"][name] for name in parameters} == expected
    assert entry["from_run"] == from_run
    with h5py.File(out / "run.h5", "r") as file:
        x, weight = file["base/x"][()], file["base/normal"][()].sum()
        bins = bins_of(file["analysis/base"], weight)
    if choice != "pile-lattice":  # its table has the sawtooth of its discs, which the steps of the quadrature smooth
        check_entry(entry, x, bins, numbers["base_dip"]["centre"], numbers["base_dip"]["half_width"])


def test_the_rest_of_the_summary_stays_and_the_list_is_replaced(lab, out):
    before = (out / "summary.json").read_text()
    files = {path: path.read_bytes() for path in out.rglob("*") if path.is_file() and path.name != "summary.json"}
    assert lab("plot", "out", *CONTINUUM, *CONTINUUM, *QUICK).returncode == 0
    assert len(summary(out)["theory"]) == 2
    assert lab("plot", "out", *CONTINUUM, *QUICK).returncode == 0
    once = (out / "summary.json").read_bytes()
    assert lab("plot", "out", *CONTINUUM, *QUICK).returncode == 0
    assert (out / "summary.json").read_bytes() == once
    text = once.decode()
    key = ',\n  "checksum": '
    assert text.startswith(before[: before.rindex(key)] + ',\n  "theory": [')
    hashed = text[: text.rindex(key)]
    assert text == f'{hashed}{key}"{xxhash.xxh3_128_hexdigest(hashed.encode())}"\n}}\n'
    whole = json.loads(text)
    assert [key for key in whole if key not in json.loads(before)] == ["theory"] and list(whole)[-1] == "checksum"
    assert '"theory": [\n    {\n      "model"' in text  # indented like the rest
    assert {path: path.read_bytes() for path in files} == files


def test_a_finished_run_keeps_it_and_an_analysis_drops_it(lab, out):
    before = (out / "summary.json").read_bytes()
    assert lab("plot", "out", *CONTINUUM, *QUICK).returncode == 0
    after = (out / "summary.json").read_bytes()
    assert lab("resume", "out", "--quiet").returncode == 0
    assert (out / "summary.json").read_bytes() == after
    assert lab("plot", "out", *QUICK).stdout.endswith("theory.png\n")
    assert lab("analyse", "out", "--quiet").returncode == 0
    assert (out / "summary.json").read_bytes() == before
    assert "theory: not drawn: no model was compared with it" in lab("plot", "out", *QUICK).stdout


@pytest.mark.parametrize("options, parts", [
    (["--theory", "nonsense"], ["--theory nonsense: no such model of theory; must be ", "pile-continuum"]),
    (["--theory", ""], ["--theory : no such model of theory"]),
    (["--theory", "pile-continuum:"], ["'': must be key=value"]),
    (["--theory", "pile-continuum:slope_deg=70"], ["pile-continuum: slope_deg = 70: must be > 0 and < 60 (deg)"]),
    (["--theory", "pile-continuum:slope_deg=1,slope_deg=2"], ["slope_deg = 2: is set twice"]),
    (["--theory", "x:a", "--theory", "pile-continuum:points=1,b=2"],
     ["--theory x:a: no such", "x:a: a: must be key=value", "points = 1: must be", "b: no such parameter"]),
    ([*CONTINUUM, "--frame", "0"], ["--theory: is overlaid on the end of the run, not on a --frame"]),
])  # fmt: skip
def test_bad_choices_are_refused_all_at_once(lab, out, options, parts):
    before = (out / "summary.json").read_bytes()
    complaint = lab.refused("plot", "out", *options, parts=parts)
    assert complaint.count("\n") == max(1, len(parts) - parts[0].endswith("must be "))
    assert (out / "summary.json").read_bytes() == before


def test_models_without_a_base_force_are_refused(lab, out):
    names = re.findall(r"^(\S+)$", lab("theory", "--list").stdout, flags=re.M)
    assert {"pile-continuum", "janssen", "janssen-discrete", "osl"} <= set(names)
    for name in ("janssen", "janssen-discrete", "osl:output=field"):
        complaint = lab.refused("plot", "out", *CONTINUUM, "--theory", name)
        assert complaint.count("\n") == 1
        assert f"{name.partition(':')[0]}: has no force on the base of a heap (x_over_b, normal, shear); models that have: " in complaint
        assert "pile-continuum" in complaint and name not in complaint.partition("models that")[2]


def flip(path, key):
    text = path.read_text()
    assert key in text
    path.write_text(text.replace(key, key[:-1] + "x", 1))


def other_state(out):
    with changed(out / "run.h5") as file:
        file.attrs["state_hash"] = np.bytes_(b"0" * 32)


def status(word):
    def change(out):
        with changed(out / "run.h5") as file:
            file.attrs["status"] = np.bytes_(word)

    return change


@pytest.mark.parametrize("damage, part", [
    (lambda out: flip(out / "summary.json", "base_dip"), "out/summary.json: damaged: its content differs from what Repose wrote"),
    (lambda out: (out / "summary.json").unlink(), "out: holds neither an analysed run nor a sweep: no summary.json"),
    (lambda out: (out / "analysis.h5").write_bytes((out / "analysis.h5").read_bytes()[:-8]), "out/analysis.h5: damaged"),
    (lambda out: (out / "run.h5").write_bytes((out / "run.h5").read_bytes()[:-8]), "out/run.h5: damaged"),
    (lambda out: shutil.rmtree(out), "out: no such folder"),
    (other_state, "out/summary.json: does not describe the last state of the run"),
    (status(b"failed"), "out: the run failed"),
    (status(b"running"), "out: the run has not finished (running): `repose resume out` continues it"),
])  # fmt: skip
def test_incomplete_runs_are_refused(lab, out, damage, part):
    damage(out)
    assert lab.refused("plot", "out", *CONTINUUM, parts=[part]).count("\n") == 1


def test_a_run_in_progress_is_refused(lab):
    lab.scene(POURED.replace("count = 150", "count = 3000").replace("time = 500", "time = 5000"))
    process = subprocess.Popen([PROGRAM, "run", "scene.toml", "--out", "out", "--quiet"], cwd=lab.path)
    try:
        while not (lab.path / "out/summary.json").exists():
            time.sleep(0.02)
        result = lab("plot", "out", *CONTINUUM)
        assert result.returncode == 2 and "out: a run is being written here by another program" in result.stderr
    finally:
        process.send_signal(signal.SIGINT)
        assert process.wait(30) == 130
    lab.refused("plot", "out", *CONTINUUM, parts=["out: the run has not finished (interrupted)"])


def test_heaps_without_a_base_or_a_slope_are_refused(lab):
    floor = "\n[[plane]]\npoint = [0, 0]\nnormal = [0, 1]\n"
    no_base = HEAP.replace('kind = "row"\nhalf_width = 8', 'kind = "none"').replace("at_rest", "# at_rest") + floor
    lab.run(no_base, out="plane")
    lab.refused("plot", "plane", *CONTINUUM, parts=["plane: no base profile: the heap stands on no base of grains and no plane"])
    few = lab.run(HEAP.replace("count = 40", "count = 6"), out="few")
    assert summary(few)["angle_of_repose_deg"]["mean"] is None and summary(few)["base_dip"] is not None
    lab.refused("plot", "few", *CONTINUUM, parts=["slope_deg must be given: the heap has no angle of repose"])
    result = lab("plot", "few", "--theory", "pile-continuum:slope_deg=20", *QUICK)
    assert result.returncode == 0, result.stderr


def test_numbers_of_a_sweep(lab, swept):
    out = lab.path / "out"
    shutil.copytree(swept, out)
    files = {path: path.read_bytes() for path in out.rglob("*") if path.is_file()}
    assert not (out / "summary.json").exists()
    result = lab("plot", "out", *CONTINUUM, "--theory", "pile-continuum:slope_deg=20", *QUICK)
    assert result.returncode == 0, result.stderr
    assert (out / "pictures/theory.png").is_file()
    entries = summary(out)["theory"]
    points = ["friction=0.2", "friction=0.5"]
    assert [entry["point"] for entry in entries] == [points[0], points[0], points[1], points[1]]
    with h5py.File(out / "sweep.h5", "r") as file:
        slopes = file["measures/angle_of_repose_deg.mean/mean"][()]
        for k, entry in enumerate(entries):
            assert entry["members"] == 3
            assert entry["parameters"]["slope_deg"] == (20 if k % 2 else slopes[k // 2])
            profile = file[f"profiles/{k // 2:04}"]
            bins = bins_of(profile["binned"], profile["normal"][()].sum())
            check_entry(entry, profile["x"][()], bins, profile.attrs["centre"], profile.attrs["half_width"])
    assert {path: path.read_bytes() for path in files} == files
    once = (out / "summary.json").read_bytes()
    assert lab("plot", "out", *CONTINUUM, "--theory", "pile-continuum:slope_deg=20", *QUICK).returncode == 0
    assert (out / "summary.json").read_bytes() == once


@pytest.mark.parametrize("again", [["analyse", "out", "--quiet"], ["sweep", "out/sweep.toml"]])
def test_tables_that_are_written_again_drop_the_summary_of_a_sweep(lab, swept, again):
    out = lab.path / "out"
    shutil.copytree(swept, out)
    assert lab("plot", "out", *CONTINUUM, *QUICK).returncode == 0
    table = (out / "table.csv").read_bytes()
    assert lab(*again).returncode == 0
    assert not (out / "summary.json").exists() and (out / "table.csv").read_bytes() == table
    assert "theory: not drawn: no model was compared with it" in lab("plot", "out", *QUICK).stdout


def test_members_with_their_own_theory_do_not_change_the_tables(lab, swept):
    out = lab.path / "out"
    shutil.copytree(swept, out)
    table = (out / "table.csv").read_bytes()
    assert lab("plot", "out/members/friction=0.2/seed-1", *CONTINUUM, *QUICK).returncode == 0
    assert lab("sweep", "out/sweep.toml").returncode == 0
    assert (out / "table.csv").read_bytes() == table
    assert "theory" in summary(out / "members/friction=0.2/seed-1")


def test_a_sweep_with_unfinished_members_is_refused(lab, swept):
    out = lab.path / "out"
    shutil.copytree(swept, out)
    shutil.rmtree(out / "members/friction=0.5/seed-2")
    assert lab("analyse", "out", "--quiet").returncode == 0
    complaint = lab.refused("plot", "out", *CONTINUUM, parts=["out: the sweep has not finished, 1 members are open"])
    assert complaint.count("\n") == 1
