# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Simulations in Python against the program: the same bits, live state, observers, interrupts."""

import doctest
import gc
import os
import signal
import subprocess
import sys
import threading
import time
import weakref

import h5py
import numpy as np
import pytest

import repose
from repose import simulation as simulation_module
from repose.program import program

from test_scene import TABLES, TOML


def small():
    return repose.Scene(TABLES)


def endless():
    """A scene that takes minutes."""
    scene = repose.Scene.example("heap")
    scene.source.count = 3000
    return scene


def test_examples_of_the_documentation():
    assert doctest.testmod(simulation_module).failed == 0


@pytest.fixture(scope="module")
def by_program(tmp_path_factory):
    folder = tmp_path_factory.mktemp("program")
    (folder / "scene.toml").write_text(TOML)
    subprocess.run([program(), "run", "scene.toml", "--out", "heap", "--quiet"], cwd=folder, check=True)
    return folder / "heap"


def test_a_run_has_the_bits_of_the_program(by_program, tmp_path):
    run = repose.run(small(), tmp_path / "heap", threads=2)
    assert (tmp_path / "heap/scene.toml").read_text() == (by_program / "scene.toml").read_text()
    with h5py.File(tmp_path / "heap/run.h5") as ours, h5py.File(by_program / "run.h5") as theirs:
        assert ours.attrs["state_hash"] == theirs.attrs["state_hash"]
    theirs = repose.open_run(by_program)
    assert run.state.grains.position.tobytes() == theirs.state.grains.position.tobytes()
    assert run.attributes["status"] == "finished" and run.analysis is not None


def test_parts_and_observers_change_no_bit(by_program):
    simulation = repose.Simulation(small())
    seen = []
    simulation.observe_every(5.0, lambda observed: seen.append((observed.time, len(observed.measures()))))
    for until in (1.0, 7.3, 40.0, np.inf):
        simulation.advance(until)
    assert simulation.status == "finished" and "at rest" in simulation.message
    with h5py.File(by_program / "run.h5") as file:
        assert simulation.state_hash == file.attrs["state_hash"]
    assert np.allclose(np.diff([when for when, _ in seen])[:-1], 5.0, atol=2 * simulation.time_step)
    assert all(count > 10 for _, count in seen)


def test_the_state_is_by_id_with_the_numbers_of_the_folder(tmp_path):
    simulation = repose.Simulation(small())
    simulation.advance(30.0)
    with simulation.state() as state:
        grains, contacts = state.grains, state.contacts
        assert state.time == simulation.time and np.all(np.diff(grains.id) > 0)
        assert grains.position.shape == (len(grains), 2) and not grains.position.flags.writeable
        with pytest.raises(ValueError, match="read-only"):
            grains.position[0] = 0.0
        with pytest.raises(RuntimeError, match="cannot advance within a block with state"):
            simulation.advance(31.0)
        saved = simulation_saved(simulation, tmp_path)
        for name in ("id", "position", "velocity", "spin", "radius", "mass", "fixed", "base", "material"):
            assert np.array_equal(getattr(grains, name), getattr(saved.state.grains, name)), name
        assert len(contacts) > 0
        for name in ("grains", "normal", "overlap", "normal_force", "tangential_force", "history", "sliding"):
            assert np.array_equal(getattr(contacts, name), getattr(saved.state.contacts, name)), name
    kept = grains.position
    simulation.advance(60.0)
    del simulation
    gc.collect()
    assert np.isfinite(kept).all()  # a view keeps the state that it is of


def simulation_saved(simulation, folder):
    """The state written by a twin that was advanced alike: this one stands still."""
    twin = repose.Simulation(small())
    twin.advance(simulation.time)
    assert twin.state_hash == simulation.state_hash
    return twin.save(folder / "saved")


def test_what_an_observer_raises_comes_out_and_the_run_continues(by_program):
    simulation = repose.Simulation(small())
    left = [1]

    def fail_once(observed):
        with pytest.raises(RuntimeError, match="cannot advance while the simulation runs"):
            observed.advance(1e9)
        if left and left.pop():
            raise LookupError("stop here")

    simulation.observe_every(10.0, fail_once)
    with pytest.raises(LookupError, match="stop here"):
        simulation.advance(np.inf)
    assert simulation.status == "running"
    simulation.advance(np.inf)
    with h5py.File(by_program / "run.h5") as file:
        assert simulation.state_hash == file.attrs["state_hash"]


def test_an_observer_keeps_no_simulation_alive():
    simulation = repose.Simulation(small())
    simulation.observe_every(1.0, lambda observed: None)
    gone = weakref.ref(simulation)
    del simulation
    gc.collect()
    assert gone() is None


def test_other_threads_run_meanwhile():
    simulation = repose.Simulation(endless())
    ticks = []
    stop = threading.Event()

    def tick():
        while not stop.wait(0.01):
            ticks.append(time.monotonic())
        simulation.interrupt()

    thread = threading.Thread(target=tick)
    threading.Timer(0.5, stop.set).start()
    thread.start()
    simulation.advance(1e9)
    thread.join()
    assert len(ticks) > 10 and simulation.status == "running"


CTRL_C = """
import repose, sys
scene = repose.Scene.example("heap")
scene.source.count = 3000
simulation = repose.Simulation(scene)
print("begun", flush=True)
try:
    simulation.{call}
except KeyboardInterrupt:
    print("interrupted at", simulation.time > 0, simulation.status, flush=True)
    simulation.{then}
    print("then", simulation.status, flush=True)
"""


@pytest.mark.parametrize(
    "call, then, status, after",
    [
        ("advance(1e9)", "advance(simulation.time + 0.01)", "running", "running"),
        ("run('out')", "measures()", "interrupted", "interrupted"),
    ],
)
def test_ctrl_c_ends_the_advance_and_nothing_else(tmp_path, call, then, status, after):
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(path for path in sys.path if path)}
    process = subprocess.Popen([sys.executable, "-c", CTRL_C.format(call=call, then=then)], cwd=tmp_path,
                               env=environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    assert process.stdout.readline() == "begun\n", process.stderr.read()
    time.sleep(1.0)
    process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=120)
    assert process.returncode == 0, err
    assert out.splitlines() == [f"interrupted at True {status}", f"then {after}"]
    if "out" in call:
        resumed = repose.Simulation.resume(tmp_path / "out")
        assert resumed.status == "running" and resumed.time > 0


def test_an_interrupted_run_resumes_to_the_same_bits(by_program, tmp_path):
    simulation = repose.Simulation(small())
    simulation.observe_every(15.0, lambda observed: observed.interrupt())
    run = simulation.run(tmp_path / "heap")
    assert run.attributes["status"] == "interrupted"
    again = repose.Simulation.resume(tmp_path / "heap")
    run = again.run()
    assert run.attributes["status"] == "finished"
    with h5py.File(by_program / "run.h5") as file:
        assert run.attributes["state_hash"] == file.attrs["state_hash"]


def test_folders_are_not_overwritten_unasked(tmp_path):
    repose.run(small(), tmp_path / "heap")
    with pytest.raises(ValueError, match="heap"):
        repose.run(small(), tmp_path / "heap")
    repose.run(small(), tmp_path / "heap", overwrite=True)


def test_analysis_and_measures_are_those_of_the_program(by_program, tmp_path):
    simulation = repose.Simulation(small())
    simulation.run()
    measures = simulation.measures()
    summary = repose.open_run(by_program).summary
    assert measures["angle_of_repose_deg.mean"] == summary["angle_of_repose_deg"]["mean"]
    assert measures["coordination"] == summary["coordination"]
    analysed = repose.analyse(by_program)
    assert analysed.summary["coordination"] == summary["coordination"]


def test_a_sweep_runs_by_the_program(tmp_path):
    (tmp_path / "scene.toml").write_text(TOML)
    (tmp_path / "sweep.toml").write_text('scene = "scene.toml"\nseeds = 2\n[vary]\ncontact.friction = [0.3, 0.5]\n')
    sweep = repose.run_sweep(tmp_path / "sweep.toml", tmp_path / "out")
    assert sweep.points == ["friction=0.3", "friction=0.5"] and list(sweep.finished) == [2, 2]
    (tmp_path / "sweep.toml").write_text('scene = "scene.toml"\nseeds = 0\n')
    with pytest.raises(ValueError, match="seeds = 0: must be"):
        repose.run_sweep(tmp_path / "sweep.toml", tmp_path / "other")


def test_data_frames_and_the_page_of_a_run(by_program):
    pandas = pytest.importorskip("pandas")
    run = repose.open_run(by_program)
    grains = run.state.grains.to_pandas()
    assert isinstance(grains, pandas.DataFrame) and list(grains["position_y"]) == list(run.state.grains.position[:, 1])
    assert len(run.state.contacts.to_pandas()) == len(run.state.contacts)
    assert list(run.series.to_pandas()["time"]) == list(run.series["time"])
    page = run._repr_html_()
    assert "finished" in page and "angle_of_repose_deg.mean" in page and "<script" not in page
