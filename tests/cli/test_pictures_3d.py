# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of runs of spheres, from the program: a small pyramid that settles on fixed spheres."""

import shutil
import sys
from pathlib import Path

import numpy as np
import pytest
from conftest import Laboratory, everything_in

PACKAGE = Path(__file__).resolve().parents[2] / "python"
LAYERS, BASE = 4, 7  # spheres along a side of the lowest layer, and of the base
DRAWN = ("projection", "slice", "forces", "force_distribution", "directions", "voronoi", "fields", "cone", "energy")


def pyramid():
    """Grains of a scene: a square base of fixed spheres, and on it square layers of touching ones."""
    lines = []
    for k in range(LAYERS + 1):
        count, height = (BASE, 0.0) if k == 0 else (LAYERS + 1 - k, k * np.sqrt(0.5))
        at = np.arange(count) - 0.5 * (count - 1)  # in the hollows of the layer below
        fixed = "fixed = true\n" if k == 0 else ""
        lines += [f"[[grain]]\nposition = [{x}, {y}, {height}]\n{fixed}" for x in at for y in at]
    return "".join(lines)


SCENE = f"""dimension = 3
{pyramid()}
[[plane]]
name = "floor"
point = [0.0, 0.0, -0.5]
normal = [0.0, 0.0, 1.0]
[contact]
friction = 0.5
normal = {{ law = "hooke", stiffness = 1e4, restitution = 0.5 }}
tangential = {{ law = "linear", stiffness = 8e3 }}
[stop]
time = 5
[output]
frames = 2.5
"""


@pytest.fixture(scope="module")
def settled(tmp_path_factory):
    lab = Laboratory(tmp_path_factory.mktemp("spheres"))
    lab.out = lab.run(SCENE)
    return lab


def pictures_of(settled, *options):
    shutil.rmtree(settled.out / "pictures", ignore_errors=True)
    result = settled("plot", "out", "--dpi", "60", *options)
    assert (result.returncode, result.stderr) == (0, "")
    return {path.name for path in (settled.out / "pictures").iterdir()}, result.stdout


def test_every_picture_is_drawn_or_has_a_reason(settled):
    names, said = pictures_of(settled, "--format", "png")
    assert {f"{name}.png" for name in DRAWN} <= names
    for line in said.splitlines():
        assert line.endswith(".png") or ": not drawn: " in line


def test_pictures_of_frames(settled):
    frames = sorted(path.stem for path in (settled.out / "frames").iterdir())
    names, _ = pictures_of(settled, "--format", "png", "--frame", "all", "--only", "projection,forces")
    assert names == {f"{name}-{frame}.png" for name in ("projection", "forces") for frame in frames}


def test_the_same_run_has_the_same_pictures(settled):
    contents = []
    for _ in range(2):
        pictures_of(settled, "--only", "projection,slice")
        contents.append([path.read_bytes() for path in sorted((settled.out / "pictures").iterdir())])
    assert contents[0] == contents[1] and len(contents[0]) == 4


def test_a_picture_of_discs_is_refused_in_one_line(settled):
    said = settled.refused("plot", "out", "--only", "stress", parts=["unknown name 'stress'", "projection"])
    assert said.count("\n") == 1


@pytest.mark.skipif(shutil.which("ffmpeg") is None, reason="there is no ffmpeg")
def test_a_movie_shows_the_projection(settled):
    result = settled("export", "out", "--to", "movie", "--format", "gif", "--dpi", "40")
    assert result.returncode == 0, result.stderr
    assert everything_in(settled.out / "export/movie") == ["heap.gif"]


def test_python_reads_three_columns(settled):
    sys.path.insert(0, str(PACKAGE))
    try:
        import repose
    finally:
        sys.path.remove(str(PACKAGE))
    run = repose.open(settled.out)
    grains, contacts = run.state.grains, run.state.contacts
    assert run.attributes["dimension"] == 3
    assert grains.position.shape == grains.velocity.shape == grains.spin.shape == (len(grains), 3)
    assert contacts.normal.shape == contacts.tangential_force.shape == (len(contacts), 3)
    np.testing.assert_allclose(np.linalg.norm(contacts.normal, axis=1), 1.0, atol=1e-12)
