# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The results of the analysis against the data of the run, and `repose analyse`, which must not change the run."""

import json
import shutil
import signal
import subprocess
import time
from pathlib import Path

import h5py
import numpy as np
import pytest
from conftest import HEAP, LIMIT, PROGRAM, changed, datasets, summary

TRACKED = HEAP.replace("count = 40", "count = 120") + "[output]\ntrack = 1\nframes = 50\n"


@pytest.fixture(scope="module")
def tracked(tmp_path_factory):
    """A heap of 120 grains with a track, at rest. Tests copy it before they change anything."""
    folder = tmp_path_factory.mktemp("tracked")
    (folder / "scene.toml").write_text(TRACKED)
    subprocess.run([PROGRAM, "run", "scene.toml", "--out", "out", "--quiet"], cwd=folder, check=True, timeout=LIMIT)
    return folder / "out"


@pytest.fixture
def analysis(tracked):
    with h5py.File(tracked / "run.h5", "r") as file:
        yield file


def untimed(path):
    numbers = json.loads((path / "summary.json").read_text())
    return {key: value for key, value in numbers.items() if "second" not in key and key != "checksum"}


def test_analyse_writes_the_same_files_and_does_not_change_the_run(lab, tracked):
    shutil.copytree(tracked, lab.path / "out")
    run_files = ["run.h5", "scene.toml", *(f"track/{p.name}" for p in (tracked / "track").iterdir())]
    before = {name: (lab.path / "out" / name).read_bytes() for name in run_files}
    for name in ("analysis.h5", "summary.json"):
        (lab.path / "out" / name).unlink()
    result = lab("analyse", "out")
    assert result.returncode == 0, result.stderr
    assert "angle of repose" in result.stdout
    for name in ("analysis.h5", "summary.json"):
        assert (lab.path / "out" / name).read_bytes() == (tracked / name).read_bytes(), name
    assert {name: (lab.path / "out" / name).read_bytes() for name in run_files} == before


def test_other_settings_of_the_analysis_are_used(lab, tracked):
    shutil.copytree(tracked, lab.path / "out")
    scene = lab.path / "out/scene.toml"
    scene.write_text(scene.read_text().replace("base_bin = 5.0", "base_bin = 3.0"))
    assert lab("analyse", "out", "--quiet").returncode == 0
    with h5py.File(lab.path / "out/analysis.h5", "r") as file:
        assert file["base"].attrs["bin_width"] == 3.0


def test_an_interrupted_run_can_be_analysed(lab):
    lab.scene(TRACKED.replace("count = 120", "count = 3000").replace("time = 500", "time = 5000"))
    process = subprocess.Popen([PROGRAM, "run", "scene.toml", "--out", "out", "--quiet"], cwd=lab.path)
    while not (lab.path / "out/frames/000000.h5").exists():
        time.sleep(0.02)
    process.send_signal(signal.SIGINT)
    assert process.wait(30) == 130
    before = summary(lab.path / "out")
    assert before["status"] == "interrupted"
    (lab.path / "out/summary.json").unlink()
    assert lab("analyse", "out", "--quiet").returncode == 0
    assert summary(lab.path / "out") == before


def test_a_killed_run_can_be_analysed(lab):
    lab.scene(TRACKED.replace("count = 120", "count = 3000").replace("time = 500", "time = 5000"))
    process = subprocess.Popen([PROGRAM, "run", "scene.toml", "--out", "out", "--quiet"], cwd=lab.path)
    while not (lab.path / "out/frames/000001.h5").exists():
        time.sleep(0.02)
    process.kill()
    process.wait()
    assert lab("analyse", "out", "--quiet").returncode == 0
    assert summary(lab.path / "out")["time"] >= 49.9  # frames come every 50, in whole steps


def test_binned_base_profile(analysis):
    x, normal = analysis["base/x"][()], analysis["base/normal"][()]
    bins = analysis["analysis/base"]
    width = bins.attrs["bin_width"]
    assert width == 5.0 and 0.0 in bins["x"][()]
    for centre, count, mean, error in zip(*(bins[name][()] for name in ("x", "count", "normal", "normal_error"))):
        inside = normal[np.floor(x / width + 0.5) == round(centre / width)]
        assert count == len(inside)
        assert mean == pytest.approx(inside.mean(), rel=1e-13)
        if count > 1:
            assert error == pytest.approx(inside.std(ddof=1) / np.sqrt(count), rel=1e-12, abs=1e-15)


def test_voronoi_cells(analysis):
    cells = analysis["analysis/voronoi"]
    radius = dict(zip(analysis["grains/id"][()], analysis["grains/radius"][()]))
    discs = np.pi * np.array([radius[k] for k in cells["id"][()]]) ** 2
    np.testing.assert_allclose(cells["solid_fraction"][()], discs / cells["area"][()], rtol=1e-12)
    offset, vertices = cells["offset"][()], cells["vertices"][()]
    for k, area in enumerate(cells["area"][()]):
        x, y = vertices[offset[k] : offset[k + 1]].T
        assert 0.5 * np.sum(x * np.roll(y, -1) - y * np.roll(x, -1)) == pytest.approx(area, rel=1e-9)
    closed = cells["closed"][()] == 1
    # Soft discs overlap by some per cent, so they may be denser than hard discs (0.907), but not by more than that.
    assert closed.sum() > 30 and (cells["solid_fraction"][()][closed] < 1.1).all()


def test_fields_integrate_to_the_weight_and_the_support(analysis, tracked):
    fields = analysis["analysis/fields"]
    area = fields.attrs["cell"] ** 2
    grains = summary(tracked)["grains"]
    assert fields["density"][()].sum() * area == pytest.approx(grains, rel=1e-12)
    assert abs(summary(tracked)["field_weight_error"]) < 1e-12
    # At rest the supports carry the weight, to the force residual of 1e-6.
    assert fields["support_y"][()].sum() * area == pytest.approx(grains, rel=1e-5)
    assert fields["density"].shape == (len(fields["y"]), len(fields["x"]))


def test_force_distribution_and_chains(analysis, tracked):
    force = analysis["contacts/normal_force"][()]
    counting = force[force > 0.2]
    forces = analysis["analysis/forces"]
    assert forces.attrs["mean"] == pytest.approx(counting.mean(), rel=1e-12)
    assert forces["density"][()].sum() * forces.attrs["bin_width"] == pytest.approx(1.0, rel=1e-12)
    chain = analysis["analysis/chains/chain"][()]
    np.testing.assert_array_equal(chain >= 0, force > counting.mean())
    np.testing.assert_array_equal(np.bincount(chain[chain >= 0]), analysis["analysis/chains/contacts"][()])
    numbers = summary(tracked)
    assert numbers["forces"]["strong_fraction"] == pytest.approx((counting > counting.mean()).mean(), rel=1e-12)
    assert numbers["chains"]["count"] == chain.max() + 1
    sliding = analysis["contacts/sliding"][()][force > 0.2]
    assert numbers["forces"]["sliding_fraction"] == pytest.approx(sliding.mean(), abs=1e-12)


def test_avalanches_from_the_track(analysis, tracked):
    """The number of grains that moved, computed again from the track."""
    moments = []
    for name in analysis["track"]:
        segment = analysis[f"track/{name}"]
        offset = segment["offset"][()]
        for m, at in enumerate(segment["time"][()]):
            rows = slice(offset[m], offset[m + 1])
            grains = zip(segment["id"][rows], segment["position"][rows].astype(float), segment["in_heap"][rows])
            moments.append((at, {k: p for k, p, touches in grains if touches}))
    assert len(moments) > 100
    motion = analysis["analysis/motion"]
    moved = [
        sum(np.hypot(*(after[k] - before[k])) > 0.5 for k in before.keys() & after.keys())
        for (_, before), (_, after) in zip(moments, moments[1:])
    ]
    np.testing.assert_array_equal(motion["moved"][()], moved)
    np.testing.assert_allclose(motion["start"][()], [at for at, _ in moments[:-1]])
    assert summary(tracked)["avalanches"]["count"] == len(analysis["analysis/avalanches/size"])


def test_without_a_track_there_are_no_avalanches(heap):
    assert summary(heap)["avalanches"] is None and summary(heap)["bursts"] is None
    with h5py.File(heap / "run.h5", "r") as file:
        assert "track" not in file and "motion" not in file["analysis"]


def test_a_lattice_pile_keeps_its_core_and_sheds_its_flanks(lab):
    """Baxter et al. (1997), section III: 60-degree piles partly collapse into buttresses that support the rest. The core is
    the lowest 30 % of the height within +- 20 % of the base, the flank the outer two diameters. A grain is kept if all its
    neighbours are still near."""
    rows, rise = 40, np.sqrt(3) / 2
    example = Path(__file__).resolve().parents[2] / "examples/pyramid-60.toml"
    result = lab("run", str(example), "--out", "out", "--quiet", "--set", "output.frames=0")
    assert result.returncode == 0, result.stderr
    out = lab.path / "out"
    with h5py.File(out / "run.h5", "r") as file:
        end = file["grains/position"][()][file["grains/fixed"][()] == 0]
    start = np.array([(k - 0.5 * (rows - 1 - row), (row + 1) * rise) for row in range(rows) for k in range(rows - row)])
    assert len(end) == len(start) == 820

    def distances(centre):
        return np.hypot(*(centre[:, None] - centre[None]).transpose(2, 0, 1))

    neighbours = (distances(start) < 1.01) & ~np.eye(820, dtype=bool)
    kept = (distances(end) < 1.2)[neighbours].reshape(-1)  # per pair
    all_kept = np.array([kept_of.all() for kept_of in np.split(kept, np.cumsum(neighbours.sum(axis=1))[:-1])])
    core = (start[:, 1] < 0.3 * rows * rise) & (np.abs(start[:, 0]) < 0.2 * rows)
    flank = 0.5 * (np.sqrt(3) * (0.5 * rows + 0.5 - np.abs(start[:, 0])) - start[:, 1]) < 2.0
    assert core.sum() == 171 and flank.sum() == 154
    assert all_kept[core].mean() > 0.9, "the core has not kept together"
    assert all_kept[flank].mean() < 0.1, "the flanks have stayed"
    assert summary(out)["angle_of_repose_deg"]["mean"] < 40


@pytest.mark.parametrize("damage, parts", [
    (lambda out: shutil.rmtree(out), ["out: no such folder"]),
    (lambda out: (out / "run.h5").unlink(), ["out: holds no run: no run.h5"]),
    (lambda out: (out / "run.h5").write_bytes((out / "run.h5").read_bytes()[:3000]), ["out/run.h5: "]),
    (lambda out: (out / "run.h5").write_text("nothing"), ["out/run.h5: damaged: too short"]),
    (lambda out: (out / "track/000000.h5").unlink(), ["track/000000.h5: is missing"]),
    (lambda out: (out / "scene.toml").write_text("seed = 'x'"), ["out/scene.toml:1: seed"]),
    (lambda out: drop(out, "contacts/lever"), ["out/run.h5: contacts/lever: no such dataset"]),
    (lambda out: shorten(out, "grains/radius"), ["out/run.h5: grains: the datasets differ in length"]),
    (lambda out: rename(out, "contacts/grains"), ["names a grain or wall that is not there"]),
])
def test_damaged_runs_are_refused(lab, tracked, damage, parts):
    shutil.copytree(tracked, lab.path / "out")
    damage(lab.path / "out")
    lab.refused("analyse", "out", parts=parts)


def drop(out, name):
    with changed(out / "run.h5") as file:
        del file[name]


def shorten(out, name):
    with changed(out / "run.h5") as file:
        values = file[name][()][:-1]
        del file[name]
        file[name] = values


def rename(out, name):
    with changed(out / "run.h5") as file:
        file[name][0, 1] = 10**6
