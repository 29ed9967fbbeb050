# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""A small heap that runs well: its files, its numbers, and the same bits in a repeated run."""

import math
import shutil

import h5py
import numpy as np
import pytest
from conftest import HEAP, Grains, assert_same_bits, datasets, everything_in, forces_on_grains, summary, text_attribute

SUMMARY_KEYS = {
    "method", "seed", "grains", "contacts", "time", "steps", "wall_seconds", "grain_steps_per_second",
    "kinetic_energy_per_grain", "force_residual", "max_overlap", "solid_fraction", "coordination", "anisotropy",
    "fabric_direction_deg", "connectivity", "angle_of_repose_deg", "base_profile", "base_dip", "weight_error",
    "grains_lost", "stop_reason", "status",
}
TIMED = ("checksum", "wall_seconds", "grain_steps_per_second", "threads")


def untimed(folder):
    return {key: value for key, value in summary(folder).items() if key not in TIMED}


def test_files(heap):
    found = everything_in(heap)
    frames = [name for name in found if name.startswith("frames/")]
    assert set(found) - set(frames) == {"analysis.h5", "frames", "run.h5", "scene.toml", "summary.json"}
    assert frames == [f"frames/{k:06}.h5" for k in range(len(frames))] and len(frames) >= 3
    with h5py.File(heap / "run.h5") as file:
        assert [f"frames/{name}.h5" for name in file["frames"]] == frames
        assert all(isinstance(file["frames"].get(n, getlink=True), h5py.ExternalLink) for n in file["frames"])


def test_header(heap):
    with h5py.File(heap / "run.h5") as file:
        has = dict(file.attrs)
    assert has["format_version"] == 4 and has["dimension"] == 2 and has["seed"] == 1 and has["periodic"] == 0
    assert has["grain_diameter"] == 1.0 and has["grain_weight"] == 1.0 and list(has["gravity"]) == [0.0, -1.0]
    assert math.isclose(has["time"], has["steps"] * has["time_step"], rel_tol=1e-12)
    for name, value in (("format", "repose-run"), ("status", "finished"), ("method", "soft"), ("units", "reduced")):
        assert text_attribute(heap / "run.h5", name) == value
    assert "at rest" in text_attribute(heap / "run.h5", "message")
    assert set(has) >= {"title", "repose_version", "x_min", "x_max"}


def test_summary_keys_and_agreement_with_the_state(heap):
    numbers = summary(heap)
    assert not SUMMARY_KEYS - set(numbers)
    assert set(numbers["angle_of_repose_deg"]) == {"left", "right", "mean", "moments"}
    assert set(numbers["base_profile"]) >= {"x", "normal", "shear"}
    assert numbers["method"] == "soft" and numbers["seed"] == 1 and numbers["grains"] == 40
    assert numbers["grains_lost"] == 0 and numbers["status"] == "finished"
    assert numbers["wall_seconds"] > 0 and numbers["grain_steps_per_second"] > 0
    found = datasets(heap / "run.h5")
    assert (found["/grains/fixed"] == 0).sum() == 40
    assert (found["/contacts/normal_force"] > 0.2).sum() == numbers["contacts"]
    assert math.isclose(numbers["max_overlap"], found["/contacts/overlap"].max(), rel_tol=1e-12)
    assert numbers["base_profile"]["normal"] == list(found["/base/normal"])
    assert numbers["base_profile"]["x"] == list(found["/base/x"])
    assert 2.0 < numbers["coordination"] < 6.0 and math.isclose(sum(numbers["connectivity"]), 1.0)
    for side in ("left", "right", "mean", "moments"):
        assert 0.0 < numbers["angle_of_repose_deg"][side] < 60.0
    assert numbers["kinetic_energy_per_grain"] < 1e-6 and numbers["force_residual"] < 1e-6


def test_the_base_carries_the_weight(heap):
    numbers = summary(heap)
    assert abs(numbers["weight_error"]) < 1e-3
    assert math.isclose(sum(numbers["base_profile"]["normal"]), 40, rel_tol=1e-3)
    assert abs(sum(numbers["base_profile"]["shear"])) < 1e-3 * 40


def test_grains(heap):
    grains = Grains(heap / "run.h5")
    assert (np.diff(grains.id) > 0).all()
    assert grains.base[:17].all() and not grains.base[17:].any() and (grains.fixed == grains.base).all()
    assert (grains.velocity[grains.fixed == 1] == 0).all()
    assert np.allclose(grains.radius, 0.5) and np.allclose(grains.mass, 1.0)
    assert grains.position.dtype == np.float64 and grains.fixed.dtype == np.uint8 and grains.id.dtype == np.int64


def test_contacts(heap):
    found = datasets(heap / "run.h5")
    pairs, normal = found["/contacts/grains"], found["/contacts/normal"]
    place = dict(zip(found["/grains/id"].tolist(), found["/grains/position"]))
    assert len({tuple(sorted(pair)) for pair in pairs.tolist()}) == len(pairs)
    assert pairs.tolist() == sorted(pairs.tolist())
    assert np.allclose(np.hypot(*normal.T), 1.0, atol=1e-12)
    for (first, second), n, overlap in zip(pairs.tolist(), normal, found["/contacts/overlap"]):
        apart = place[first] - place[second]
        distance = np.hypot(*apart)
        assert np.allclose(apart / distance, n, atol=1e-12)
        assert math.isclose(1.0 - distance, overlap, abs_tol=1e-12)
    limit = 0.5 * found["/contacts/normal_force"] + 1e-4
    assert (np.abs(found["/contacts/tangential_force"]) <= limit).all()


def test_forces_balance(heap):
    grains = Grains(heap / "run.h5")
    net = forces_on_grains(heap / "run.h5")
    residual = [np.hypot(*(net[int(k)] + [0.0, -1.0])) for k in grains.moving("id")]
    assert np.mean(residual) < 1e-6 and np.max(residual) < 1e-4
    assert math.isclose(np.mean(residual), summary(heap)["force_residual"], rel_tol=1e-6)
    held = sum(-net[int(k)][1] for k in grains.id[grains.fixed == 1])
    assert math.isclose(held, 40.0, rel_tol=1e-5)


def test_series_and_frames(heap):
    found = datasets(heap / "run.h5")
    time = found["/series/time"]
    # The last row is that of the end, at rest, whenever that is.
    assert (np.diff(time) > 0).all() and abs(np.diff(time)[:-1] - 1.0).max() < 0.01 and np.diff(time)[-1] < 1.01
    assert (np.diff(found["/series/grains"]) >= 0).all() and found["/series/grains"][-1] == 40
    with h5py.File(heap / "run.h5") as file:
        times = [file[f"frames/{name}"].attrs["time"] for name in sorted(file["frames"])]
        assert math.isclose(time[-1], file.attrs["time"])
    assert np.allclose(np.diff(times), 10.0, atol=0.5) and math.isclose(times[0], 10.0, abs_tol=0.5)
    assert (found["/analysis/surface/height"][found["/analysis/surface/used"] == 1] > 0).all()


@pytest.mark.parametrize("options", [[], ["--threads", "2"], ["--threads", "3"]])
def test_complete_scene_gives_the_same_bits(lab, heap, options):
    shutil.copy(heap / "scene.toml", lab.path / "again.toml")
    result = lab("run", "again.toml", "--out", "out", "--quiet", *options)
    assert result.returncode == 0, result.stderr
    assert (lab.path / "out/scene.toml").read_text() == (heap / "scene.toml").read_text()
    assert_same_bits(heap / "run.h5", lab.path / "out/run.h5")
    assert untimed(lab.path / "out") == untimed(heap)


@pytest.mark.parametrize("settings", [
    ["grains.polydispersity=0.6", "seed=5"], ["box.x=periodic", "contact.normal.law=hooke", "box.half_width=8"],
    ["base.kind=plane", "method.skin=0.1"],
])
def test_threads_and_the_complete_scene_for_other_scenes(lab, settings):
    options = [part for setting in settings for part in ("--set", setting)] + ["--set", "stop.time=30"]
    text = HEAP.replace("half_width = 8\n", "") if "base.kind=plane" in settings else HEAP
    one = lab.run(text, *options, "--threads", "1")
    assert_same_bits(one / "run.h5", lab.run(text, *options, "--threads", "3", out="three") / "run.h5")
    assert_same_bits(one / "run.h5", lab.run((one / "scene.toml").read_text(), out="again") / "run.h5")


def test_seed(lab):
    text = HEAP + "[output]\nframes = 0\n"
    short = ("--set", "stop.time=30")
    one = lab.run(text, *short)
    option = lab.run(text, *short, "--seed", "2", out="option")
    setting = lab.run(text, *short, "--set", "seed=2", out="setting")
    written = lab.run("seed = 2\n" + text, *short, out="written")
    assert_same_bits(option / "run.h5", setting / "run.h5")
    assert_same_bits(option / "run.h5", written / "run.h5")
    assert not (option / "frames").exists()
    assert (Grains(one / "run.h5").position != Grains(option / "run.h5").position).any()
    assert summary(option)["seed"] == 2


def test_stop(lab):
    only_rest = HEAP.replace("time = 500\n", "")
    only_time = HEAP.replace("at_rest = 1e-6\n", "")
    rest = summary(lab.run(only_rest, out="rest"))
    assert "at rest" in rest["stop_reason"] and 40 < rest["time"] < 500
    time = summary(lab.run(only_time, "--set", "stop.time=21.5", out="time"))
    assert "stop.time = 21.5" in time["stop_reason"]
    assert abs(time["time"] - 21.5) <= time["steps"] ** -1 * 21.5
    early = summary(lab.run(HEAP, "--set", "stop.time=20", out="early"))
    assert "stop.time" in early["stop_reason"] and "at rest" not in early["stop_reason"]
    late = summary(lab.run(HEAP, out="late"))
    assert "at rest" in late["stop_reason"] and late["time"] == rest["time"]
    # Only after the last grain was released: a grain at rest while others are still to come does not end the run.
    slow = summary(lab.run(HEAP, "--set", "source.count=2", "--set", "source.rate=0.01", out="slow"))
    assert slow["grains"] == 2 and slow["time"] > 100


def test_quiet_and_not_quiet(lab):
    lab.scene(HEAP)
    quiet = lab("run", "scene.toml", "--out", "quiet", "--quiet")
    assert (quiet.returncode, quiet.stdout, quiet.stderr) == (0, "", "")
    loud = lab("run", "scene.toml", "--out", "loud")
    assert loud.returncode == 0 and "at rest" in loud.stdout and "angle of repose" in loud.stdout


def test_check_writes_no_file_and_prints_the_step(lab):
    lab.scene(HEAP)
    result = lab("check", "scene.toml")
    assert result.returncode == 0 and result.stderr == ""
    assert "(auto; w dt = 0.5" in result.stdout and "half-step" in result.stdout
    result = lab("check", "scene.toml", "--set", "method.time_step=0.002")
    assert result.returncode == 0 and "0.002 (given; w dt = " in result.stdout
    assert everything_in(lab.path) == ["scene.toml"]


def test_help_and_version(lab):
    for options in (["--help"], ["run", "--help"], ["check", "--help"], ["--version"]):
        result = lab(*options)
        assert result.returncode == 0 and result.stdout.strip() and not result.stderr


def test_si_units_give_the_same_heap(lab):
    """The same scene in SI units: the diameter is 3 mm, the mass 0.02 kg, and the unit of time sqrt(d / g)."""
    d, m, g = 0.003, 0.02, 9.81
    t = math.sqrt(d / g)
    si = f"""units = "SI"
[grains]
diameter = {d}
mass = {m}
[base]
kind = "row"
half_width = {8 * d}
[source]
kind = "pour"
count = 8
rate = {1 / t}
height = {10 * d}
half_width = {2 * d}
[stop]
time = {15 * t}
"""
    reduced = HEAP.replace("count = 40", "count = 8").replace("at_rest = 1e-6\n", "")
    a = lab.run(si, out="si")
    b = lab.run(reduced, "--set", "stop.time=15", out="reduced")
    assert np.allclose(Grains(a / "run.h5").position / d, Grains(b / "run.h5").position, atol=1e-6)
