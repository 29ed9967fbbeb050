# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Sources, species, bases and starts, from scene files. Units: grain diameter, grain mass, gravity."""

import shutil
import signal
import subprocess
import time
from pathlib import Path

import numpy as np
import pytest
from conftest import HEAP, LIMIT, PROGRAM, Grains, assert_same_bits, changed, datasets, summary

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
HOOKE = (
    "[method]\ntime_step = 0.001\n[contact]\nnormal = { law = 'hooke', stiffness = 1e4 }\n"
    "tangential = { law = 'linear', stiffness = 5e3, damping = 0.1 }\n"
)


def example(lab, name, *options, out="out"):
    result = lab("run", EXAMPLES / f"{name}.toml", "--out", out, "--quiet", *options)
    assert result.returncode == 0, result.stderr
    return lab.path / out


def settings(*pairs):
    return [word for pair in pairs for word in ("--set", pair)]


def moved(first, second):
    """The largest displacement of a grain between the final states of two runs, which must have the same ids."""
    a, b = (datasets(folder / "run.h5") for folder in (first, second))
    assert (a["/grains/id"] == b["/grains/id"]).all()
    return np.abs(a["/grains/position"] - b["/grains/position"]).max()


# The scenes of the examples folder, shortened: all grains were released, and no overlap is deep.
@pytest.mark.parametrize(
    ("name", "cuts", "grains"),
    [
        ("rain", ("source.count=60", "stop.time=12"), 60),
        ("species", ("source.count=40", "stop.time=20"), 40),
        ("deposited-base", ("source.count=60", "stop.time=12"), 60),
        ("pour-above-apex", ("source.count=20", "stop.time=25"), 20),
        ("block", ("source.rows=6", "stop.time=10"), 120),
    ],
)
def test_examples(lab, name, cuts, grains):
    result = summary(example(lab, name, *settings(*cuts)))
    assert result["grains"] + result["grains_lost"] == grains
    assert result["max_overlap"] < 0.1


# The opening stays 3 above the apex of the heap; the heap would bury an opening at the fixed height 3.
def test_opening_above_the_apex_is_never_buried(lab):
    cuts = settings("source.count=150", "source.rate=2", "stop.time=200", "source.half_width=0.5")
    out = example(lab, "pour-above-apex", *cuts)
    grains = Grains(out / "run.h5")
    assert (grains.fixed == 0).sum() == 150
    assert grains.position[:, 1].max() > 5.0
    result = lab("run", EXAMPLES / "pour-above-apex.toml", "--out", "low", "--quiet", *cuts, "--set",
                 "source.height_above=base", "--set", "stop.time=400")
    assert result.returncode == 1
    assert "the source is buried: grain" in result.stderr and "finds no room at height 3" in result.stderr


# The fractions by mass of 800 grains are 0.5 within 0.05 (4 standard errors, given by the about 60 large grains). Large
# grains lie farther outside: segregation on the flanks.
def test_species(lab):
    grains = Grains(example(lab, "species", *settings("stop.time=225", "base.half_width=80", "box.half_width=100")) / "run.h5")
    coarse = grains.moving("material") == 1
    diameter = 2 * grains.moving("radius")
    mass = grains.moving("mass")
    assert ((diameter[coarse] >= 1.2) & (diameter[coarse] <= 1.6)).all()
    assert ((diameter[~coarse] >= 0.4) & (diameter[~coarse] <= 1.0)).all()
    assert np.allclose(mass, np.where(coarse, 0.6, 1.0) * diameter**2, rtol=1e-14)
    fraction = mass[coarse].sum() / mass.sum()
    count = coarse.sum()
    assert fraction == pytest.approx(0.5, abs=4 * 0.5 * 0.5 / np.sqrt(count) * 1.1)
    out = np.abs(grains.moving("position")[:, 0])
    assert np.median(out[coarse]) > 1.2 * np.median(out[~coarse])


# A poured heap rests on the deposited base: no grain is below it, and none is lost in the periodic box.
def test_deposited_base_holds_everything(lab):
    out = example(lab, "deposited-base", *settings("source.count=150", "stop.time=60"))
    grains = Grains(out / "run.h5")
    assert summary(out)["grains_lost"] == 0
    assert grains.moving("position")[:, 1].min() > 0.0
    assert (grains.base == grains.fixed).all()


SPECIES = (
    "[[species]]\nname = 'a'\nsizes = { kind = 'log-normal', mean = 0.8, deviation = 0.1 }\n"
    "[[species]]\nname = 'b'\nshare = 0.3\nsizes = { kind = 'table', diameters = [1.0, 1.5], weights = [2, 1] }\n"
)
RAIN = (
    HOOKE + SPECIES + "[base]\nkind = 'deposited'\nhalf_width = 12\n[box]\nx = 'periodic'\n[source]\nkind = 'rain'\n"
    "count = 200\nrate = 30\nheight = 4\nheight_above = 'apex'\nvelocity = [0.5, -0.5]\n[stop]\ntime = 12\n"
)


# The same scene and seed give the same bits for any number of threads; another seed gives other grains.
def test_threads_and_seeds(lab):
    one = lab.run(RAIN, "--threads", "1", out="one")
    for threads in (2, 3):
        assert summary(lab.run(RAIN, "--threads", threads, out=f"out{threads}"))["state_hash"] == summary(one)["state_hash"]
    other = lab.run(RAIN, "--seed", "2", out="other")
    assert (Grains(one / "run.h5").moving("radius")[:5] != Grains(other / "run.h5").moving("radius")[:5]).all()


# A run stopped during the rain and resumed has the bits of a run that was never stopped.
def test_rain_resumes_after_a_stop(lab):
    scene = RAIN.replace("time = 12", "time = 40").replace("count = 200", "count = 900") + "[output]\nframes = 3\n"
    whole = lab.run(scene, out="whole")
    process = subprocess.Popen([PROGRAM, "run", "scene.toml", "--out", "cut", "--quiet"], cwd=lab.path)
    for _ in range(2000):  # until the second frame, at time 6
        if (lab.path / "cut/frames/000001.h5").exists():
            break
        time.sleep(0.01)
    process.send_signal(signal.SIGINT)
    assert process.wait(timeout=LIMIT) == 130
    assert Grains(lab.path / "cut/run.h5").time < 30.0
    assert lab("resume", "cut", "--quiet").returncode == 0
    assert summary(lab.path / "cut")["state_hash"] == summary(whole)["state_hash"]


PLACED = [(0.0, 0.5, 1.0, 0.1, 0.0, 2.5, 0), (1.3, 2.25, 0.8, -0.3, 0.2, -1.0, 0), (4.0, 0.5, 1.0, 0.0, 0.0, 0.0, 1)]


# Grains from a file are those that [[grain]] would place, to the bit.
def test_file_equals_placed_grains(lab):
    rest = HOOKE + "[base]\nkind = 'plane'\n[stop]\ntime = 5\n"
    placed = "".join(
        f"[[grain]]\nposition = [{x}, {y}]\ndiameter = {d}\nvelocity = [{vx}, {vy}]\nspin = {spin}\n"
        f"fixed = {'true' if fixed else 'false'}\n"
        for x, y, d, vx, vy, spin, fixed in PLACED
    )
    table = "x,y,diameter,vx,vy,spin,fixed\n" + "".join(",".join(map(str, row)) + "\n" for row in PLACED)
    (lab.path / "grains.csv").write_text(table)
    one = lab.run(placed + rest, out="one")
    other = lab.run("[start]\nfrom = 'grains.csv'\n" + rest, out="other")
    assert summary(one)["state_hash"] == summary(other)["state_hash"]
    assert (other / "start.csv").read_text() == table


# A run can start from an export: a table, or a LAMMPS dump with several snapshots.
@pytest.mark.parametrize(("format", "name"), [("csv", "grains.csv"), ("ovito", "grains.dump")])
def test_start_from_an_export(lab, heap, format, name):
    exported = lab("export", heap, "--to", format, "--out", "export")
    assert exported.returncode == 0, exported.stderr
    found = [path for path in (lab.path / "export").rglob(name)]
    assert len(found) == 1
    out = lab.run(f"[start]\nfrom = '{found[0]}'\n[box]\nhalf_width = 28\n[stop]\ntime = 1e-9\n")
    before, after = Grains(heap / "run.h5"), Grains(out / "run.h5")
    for column in ("radius", "mass", "fixed", "base", "material"):
        assert (getattr(before, column) == getattr(after, column)).all(), column
    assert np.abs(before.position - after.position).max() < 1e-4  # one step
    assert (out / f"start{found[0].suffix}").read_bytes() == found[0].read_bytes()


# A run folder contains its start: it can be run again, analysed and moved after the file was removed.
def test_run_folder_keeps_what_it_started_from(lab):
    (lab.path / "grains.csv").write_text("x,y,radius\n0,0.5,0.5\n1.1,0.5,0.5\n")
    out = lab.run("[start]\nfrom = 'grains.csv'\n[base]\nkind = 'plane'\n[stop]\ntime = 3\n")
    (lab.path / "grains.csv").unlink()
    out.rename(lab.path / "moved")
    again = lab("run", "moved/scene.toml", "--out", "again", "--quiet")
    assert again.returncode == 0, again.stderr
    assert summary(lab.path / "again")["state_hash"] == summary(lab.path / "moved")["state_hash"]
    assert lab("analyse", "moved").returncode == 0
    over = lab("run", "again/scene.toml", "--out", "again", "--quiet", "--overwrite")
    assert over.returncode == 0, over.stderr
    assert summary(lab.path / "again")["state_hash"] == summary(lab.path / "moved")["state_hash"]


def start_from(heap, *, friction=0.5, source="", more="", at_rest="true", law=""):
    return (
        f"[start]\nfrom = '{heap}'\nat_rest = {at_rest}\n[contact]\nfriction = {friction}\n{law}"
        f"[box]\nhalf_width = 28\n{more}{source}[stop]\ntime = 10\n"
    )


# A heap at rest that starts a new run with the same parameters stays at rest, because contacts keep their slip
# displacements. Without them the grains would move by some hundredths, as another tangential law shows.
def test_same_parameters_give_no_kick(lab, heap):
    out = lab.run(start_from(heap))
    found = datasets(out / "run.h5")
    assert found["/series/kinetic_energy_per_grain"].max() < 1e-8
    assert moved(heap, out) < 1e-3
    law = "tangential = { law = 'linear', stiffness = 200 }\n"
    assert moved(heap, lab.run(start_from(heap, law=law), out="other")) > 1e-3


# More friction hardly moves a heap. Without friction a heap of unequal discs collapses; a heap of equal discs on a row of
# the same discs would stand.
def test_changed_friction(lab):
    scene = (
        HOOKE + "[grains]\npolydispersity = 0.3\n[base]\nkind = 'row'\nhalf_width = 12\n[source]\nkind = 'pour'\n"
        "count = 60\nrate = 2\nheight = 2\nheight_above = 'apex'\nhalf_width = 1\n[stop]\nat_rest = 1e-6\ntime = 300\n"
    )
    heap = lab.run(scene, out="heap")
    law = HOOKE.replace("[contact]\n", "").replace("[method]\ntime_step = 0.001\n", "")
    more = "[method]\ntime_step = 0.001\n"
    assert moved(heap, lab.run(start_from("heap", friction=0.9, law=law, more=more), out="more")) < 1e-3
    out = lab.run(start_from("heap", friction=0.0, law=law, more=more), out="none")
    kept, fallen = Grains(heap / "run.h5"), Grains(out / "run.h5")
    assert fallen.moving("position")[:, 1].mean() < 0.9 * kept.moving("position")[:, 1].mean()


# Velocities are kept unless the scene drops them. The base is kept, and grains poured on top get new ids.
def test_pour_on_top_of_a_run(lab, heap):
    source = "[source]\nkind = 'pour'\ncount = 10\nrate = 5\nheight = 4\nheight_above = 'apex'\nhalf_width = 1\n"
    out = lab.run(start_from(heap, source=source))
    before, after = Grains(heap / "run.h5"), Grains(out / "run.h5")
    assert after.id.max() == before.id.max() + 10
    assert (after.base == 1).sum() == (before.base == 1).sum()
    assert summary(out)["grains"] + summary(out)["grains_lost"] == (before.fixed == 0).sum() + 10


def test_velocities_are_kept(lab):
    scene = "[[grain]]\nposition = [0.0, 50.0]\nvelocity = [1.0, 0.0]\nspin = 2.0\n[stop]\ntime = 2\n"
    first = lab.run(scene, out="first")
    assert Grains(lab.run("[start]\nfrom = 'first'\n[stop]\ntime = 2\n", out="on") / "run.h5").position[0, 0] == (
        pytest.approx(4.0, rel=1e-3))
    out = lab.run("[start]\nfrom = 'first'\nat_rest = true\n[stop]\ntime = 2\n", out="rest")
    grains = Grains(out / "run.h5")
    assert grains.position[0, 0] == Grains(first / "run.h5").position[0, 0] and grains.spin[0] == 0.0


# Slip displacements of contacts with walls are assigned by the names of the walls.
def test_walls_by_name(lab):
    base = (
        HOOKE + "[[plane]]\nname = 'slope'\npoint = [0.0, 0.0]\nnormal = [-0.17, 1.0]\n[[plane]]\nname = 'stop'\n"
        "point = [-3.0, 0.0]\nnormal = [1.0, 0.17]\n"
    )
    first = lab.run(base + "[[grain]]\nposition = [-2.4, 0.2]\n[stop]\nat_rest = 1e-9\ntime = 200\n", out="first")
    swapped = (
        HOOKE + "[start]\nfrom = 'first'\nat_rest = true\n[[plane]]\nname = 'stop'\npoint = [-3.0, 0.0]\n"
        "normal = [1.0, 0.17]\n[[plane]]\nname = 'slope'\npoint = [0.0, 0.0]\nnormal = [-0.17, 1.0]\n[stop]\ntime = 5\n"
    )
    assert np.abs(datasets(first / "run.h5")["/contacts/history"]).max() > 1e-6
    assert moved(first, lab.run(swapped, out="on")) < 1e-7
    renamed = swapped.replace("'slope'", "'ramp'").replace("'stop'", "'end'")
    assert moved(first, lab.run(renamed, out="renamed")) > 1e-7


def test_refused_starts(lab, heap):
    def refused(text, *parts):
        lab.refused("run", lab.scene(text), "--out", "out", parts=parts)

    refused("[start]\nfrom = 'nowhere'\n[stop]\ntime = 1\n", 'scene.toml:2: start.from = "nowhere": nowhere: no such file')
    refused(f"[start]\nfrom = '{heap}'\n[base]\nkind = 'row'\nhalf_width = 20\n[stop]\ntime = 1\n",
            'scene.toml:4: base.kind = "row": the grains of start.from bring their base')
    refused(f"[start]\nfrom = '{heap}'\n[box]\nhalf_width = 4\n[stop]\ntime = 1\n", "scene.toml:2: start.from", "outside the box")
    (lab.path / "bad.csv").write_text("x,y,radius,colour\n0,0,0.5,1\n0,zero,0.5\n0,0,-1,1\n")
    refused("[start]\nfrom = 'bad.csv'\n[stop]\ntime = 1\n", "bad.csv:3: has 3 values; must have 4",
            "bad.csv:4: radius = -1: must be > 0")
    damaged = lab.path / "damaged"
    shutil.copytree(heap, damaged)
    content = bytearray((damaged / "run.h5").read_bytes())
    content[len(content) // 2] ^= 1
    (damaged / "run.h5").write_bytes(content)
    refused("[start]\nfrom = 'damaged'\n[stop]\ntime = 1\n", "scene.toml:2: start.from", "damaged/run.h5: ")
    shutil.copy(heap / "run.h5", damaged / "run.h5")
    with changed(damaged / "run.h5") as file:
        file["grains/radius"][3] = -1.0
    refused("[start]\nfrom = 'damaged'\n[stop]\ntime = 1\n", "3 has no place, or no radius and mass > 0")


@pytest.mark.parametrize(
    ("scene", "part"),
    [
        ("[source]\nkind = 'rain'\ncount = 5\nrate = 1\nhalf_width = 300\n", "source.half_width = 300: the opening must lie"),
        ("gravity = 0\n[contact]\nnormal.law = 'hooke'\n[source]\nkind = 'rain'\ncount = 5\nrate = 1\n", 'source.kind = "rain": needs gravity > 0'),
        ("[source]\nkind = 'lattice'\nrows = 3\ncolumns = 500\n", "source.columns = 500: the block must lie within the box"),
        ("[source]\nkind = 'lattice'\nrows = 3\ncolumns = 5\njitter = 2\n", "source.jitter = 2: must be"),
        ("[source]\nkind = 'pour'\ncount = 5\nrate = 1\nheight_above = 'moon'\n", "must be one of \"base\", \"apex\""),
        ("[base]\nkind = 'deposited'\nhalf_width = 20\nroughness = 0.7\n", "base.roughness = 0.7: must be at most 0.5"),
        ("[base]\nkind = 'deposited'\nhalf_width = 0.4\n", "base.half_width = 0.4: too narrow for a deposited base"),
        ("[[species]]\nsizes = { kind = 'uniform', low = 2, high = 1 }\n", "species[0].sizes.high = 1: must be >= low = 2"),
        ("[[species]]\nsizes = { kind = 'normal', mean = 1, deviation = 0.5 }\n", "its default is -0.5: must be > 0"),
        ("[[species]]\nsizes = { kind = 'normal', mean = 1, deviation = 0.1, low = 1.9, high = 2 }\n", "of the distribution"),
        ("[[species]]\nsizes = { kind = 'table', diameters = [1, 2], weights = [1] }\n", "has 1 numbers; must have 2"),
        ("[[species]]\nsizes = { kind = 'table', diameters = [1, 2], weights = [0, 0] }\n", "must have a finite sum > 0"),
        ("[[species]]\nsizes = { kind = 'sieve', diameters = [2, 1], passing = [0, 1] }\n", "each larger than the one before"),
        ("[[species]]\nsizes = { kind = 'sieve', diameters = [1, 2], passing = [0, 0.9] }\n", "must rise from 0 to 1"),
        ("[[species]]\nmaterial = 'gold'\n", 'species[0].material = "gold": must be one of'),
        ("[grains]\npolydispersity = 0.1\n[[species]]\nname = 'a'\n", "grains.polydispersity = 0.1: must be 0 with [[species]]"),
    ],
)
def test_refused_scenes(lab, scene, part):
    lab.refused("run", lab.scene(scene + "[[grain]]\nposition = [0.0, 1.0]\n[stop]\ntime = 1\n"), "--out", "out", parts=(part,))
