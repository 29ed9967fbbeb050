# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Exports of runs of spheres, against run.h5. Units: grain diameter, grain mass, gravity."""

import h5py
import numpy as np


def test_exports_of_spheres(lab):
    """A cylinder of radius 2.5 and height 3, open at both ends, in 48 segments of 2 triangles; three spheres fall into it."""
    out = lab.run("""dimension = 3
[base]
kind = "plane"
[box]
half_width = 4
x = "periodic"
y = "periodic"
half_depth = 4
[[wall]]
shape = "cylinder"
from = [0.0, 0.0, 0.0]
to = [0.0, 0.0, 3.0]
radius = 2.5
[[grain]]
position = [0.0, 0.3, 0.6]
velocity = [0.1, 0.2, 0.0]
spin = [0.5, 1.0, 2.0]
[[grain]]
position = [0.4, 0.5, 1.5]
[[grain]]
position = [-0.9, -0.4, 0.7]
diameter = 0.8
[stop]
time = 1
[output]
frames = 1.0
""")
    with h5py.File(out / "run.h5") as file:
        grains = {name: file[f"grains/{name}"][()] for name in ("position", "velocity", "spin")}
    for kind in ("vtk", "ovito", "csv"):
        result = lab("export", "out", "--to", kind)
        assert result.returncode == 0, result.stderr
    export = out / "export"
    dump = (export / "ovito/grains.dump").read_text().split("ITEM: TIMESTEP")[-1]
    assert "ITEM: BOX BOUNDS pp pp ff" in dump
    assert "z" in dump and "omegax omegay omegaz" in dump
    header, rows = dump.split("ITEM: ATOMS ")[1].split("\n", 1)
    columns = header.split()
    table = np.array([[float(value) for value in row.split()] for row in rows.strip().split("\n")])
    table = table[np.argsort(table[:, columns.index("id")])]
    for names, data in (("x y z", "position"), ("vx vy vz", "velocity"), ("omegax omegay omegaz", "spin")):
        assert (table[:, [columns.index(name) for name in names.split()]] == grains[data]).all()
    csv_header = next(line for line in (export / "csv/grains.csv").read_text().splitlines() if not line.startswith("#"))
    for name in ("position_z", "spin_x", "spin_y", "spin_z"):
        assert name in csv_header.split(",")
    last = sorted((export / "vtk").glob("grains_*.vtp"))[-1].read_text(errors="replace")
    assert 'Name="spin"' in last and 'Name="stress"' in last
    lab.refused("export", "out", "--to", "contact-problem", parts=["out: "])
