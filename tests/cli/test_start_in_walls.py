# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Grains of a file that lie in or behind walls are refused with their ids, as placed grains are."""

from conftest import repose

SCENE = """
[start]
from = "grains.csv"
[[plane]]
name = "floor"
point = [0.0, 0.0]
normal = [0.0, 1.0]
[[wall]]
name = "shelf"
from = [4.0, 3.0]
to = [8.0, 3.0]
[stop]
time = 0.01
"""


def check(folder, *grains):
    (folder / "scene.toml").write_text(SCENE)
    (folder / "grains.csv").write_text("\n".join(["id,x,y,radius,fixed", *grains, ""]))
    return repose("check", "scene.toml", cwd=folder)


def test_grains_in_and_behind_walls_are_named(tmp_path):
    done = check(tmp_path, "3,0,0.5,0.5,0", "11,2,-4,0.5,0", "12,6,3.2,0.5,0", "20,6,-9,0.5,1")
    lines = done.stderr.splitlines()
    assert done.returncode == 2 and len(lines) == 2, done.stderr
    assert "start.from" in lines[0] and "grain 11" in lines[0] and 'behind wall "floor"' in lines[0]
    assert "grain 12" in lines[1] and 'wall "shelf" presses into it by 0.3 diameters' in lines[1]


def test_a_light_touch_is_allowed_and_many_are_counted(tmp_path):
    assert check(tmp_path, "1,0,0.45,0.5,0", "2,6,3.45,0.5,0").returncode == 0
    done = check(tmp_path, *(f"{k},{1.1 * k},-3,0.5,0" for k in range(15)))
    assert done.returncode == 2 and len(done.stderr.splitlines()) == 11
    assert "and 5 more grains in or behind walls" in done.stderr
