# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Exports, read back by VTK, by a reader of LAMMPS dumps of a few lines, and as tables."""

from xml.etree import ElementTree

import h5py
import numpy as np
import pytest
from conftest import HEAP, datasets, everything_in

FRAMES = "[output]\nframes = 10\n"
SCENES = {
    "heap": HEAP + FRAMES,
    "periodic": HEAP.replace("half_width = 8\n", "half_width = 8\n[box]\nx = 'periodic'\n").replace("count = 40", "count = 90") + FRAMES,
    "walls": "[contact]\nnormal = { law = 'hooke', stiffness = 5e3 }\n[base]\nkind = 'plane'\n[[plane]]\npoint = [-4, 0]\nnormal = [1, 0]\n"
             "[[plane]]\npoint = [4, 0]\nnormal = [-1, 0]\n" + HEAP[HEAP.index("[source]"):] + FRAMES,
}


@pytest.fixture(scope="module", params=SCENES)
def run(request, tmp_path_factory):
    from conftest import Laboratory

    lab = Laboratory(tmp_path_factory.mktemp(request.param))
    lab.out = lab.run(SCENES[request.param])
    lab.found = datasets(lab.out / "run.h5")
    with h5py.File(lab.out / "run.h5") as file:
        lab.time = file.attrs["time"]
        lab.frames = [file[f"frames/{name}"].attrs["time"] for name in sorted(file["frames"])]
    return lab


def exported(lab, *options):
    result = lab("export", "out", *options)
    assert result.returncode == 0, result.stderr
    return result.stdout


def vtp(path):
    vtk = pytest.importorskip("vtkmodules.vtkIOXML")
    from vtkmodules.util.numpy_support import vtk_to_numpy

    reader = vtk.vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    data = reader.GetOutput()
    point, cell = data.GetPointData(), data.GetCellData()

    def arrays(of):
        return {of.GetArrayName(k): vtk_to_numpy(of.GetArray(k)) for k in range(of.GetNumberOfArrays())}

    points = vtk_to_numpy(data.GetPoints().GetData()) if data.GetNumberOfPoints() else np.zeros((0, 3))
    return data, points, arrays(point), arrays(cell)


def test_vtk(run):
    exported(run, "--to", "vtk")
    out = run.out / "export/vtk"
    times = {}
    for series in ("grains", "contacts"):
        sets = ElementTree.parse(out / f"{series}.pvd").getroot().findall(".//DataSet")
        times[series] = [float(part.get("timestep")) for part in sets]
        assert times[series] == [*run.frames, run.time]
        assert all((out / part.get("file")).is_file() for part in sets)
    last = f"{len(run.frames):06}.vtp"
    data, points, grains, _ = vtp(out / f"grains_{last}")
    found = run.found
    assert data.GetNumberOfVerts() == len(points) == len(found["/grains/id"])
    assert (points[:, :2] == found["/grains/position"]).all() and (points[:, 2] == 0).all()
    assert (grains["velocity"][:, :2] == found["/grains/velocity"]).all()
    for name in ("id", "radius", "mass", "fixed", "base", "material"):
        assert (grains[name] == found[f"/grains/{name}"]).all(), name
    assert np.allclose(grains["spin"], found["/grains/spin"], rtol=1e-15)
    pressed = found["/contacts/normal_force"] > 0
    pairs = found["/contacts/grains"][pressed]
    assert grains["contacts"].sum() == len(pairs) + (pairs[:, 1] >= 0).sum()

    data, points, _, contacts = vtp(out / f"contacts_{last}")
    assert data.GetNumberOfLines() == len(found["/contacts/overlap"]) and data.GetNumberOfVerts() == 0
    assert (contacts["grains"] == found["/contacts/grains"]).all()
    for name in ("normal_force", "tangential_force", "overlap", "sliding"):
        assert (contacts[name] == found[f"/contacts/{name}"]).all(), name
    # A line is as long as the distance of the centres, also across a periodic side, or as the radius at a wall.
    ends = points.reshape(-1, 2, 3)
    radius = dict(zip(found["/grains/id"], found["/grains/radius"]))
    rigid = np.array([radius[i] + (radius[j] if j >= 0 else 0.0) for i, j in found["/contacts/grains"]])
    beside = np.where(found["/contacts/grains"][:, 1] >= 0, found["/contacts/overlap"], 0.0)
    assert np.allclose(np.hypot(*(ends[:, 0] - ends[:, 1])[:, :2].T), rigid - beside, atol=1e-12)
    assert np.allclose(contacts["force"][:, :2], found["/contacts/normal_force"][:, None] * found["/contacts/normal"]
                       + found["/contacts/tangential_force"][:, None] * found["/contacts/normal"][:, ::-1] * [-1, 1])


def snapshots(path):
    """[(header items, column names, rows)] of a LAMMPS dump."""
    found, lines = [], iter(path.read_text().splitlines())
    header = {}
    for line in lines:
        item = line.removeprefix("ITEM: ")
        if item.startswith("TIMESTEP"):
            header = {"step": int(next(lines))}
        elif item.startswith("TIME"):
            header["time"] = float(next(lines))
        elif item.startswith("NUMBER"):
            header["count"] = int(next(lines))
        elif item.startswith("BOX BOUNDS"):
            header["box"] = item.split()[2:], [[float(x) for x in next(lines).split()] for _ in range(3)]
        else:
            names = item.split()[1:]
            rows = np.array([[float(x) for x in next(lines).split()] for _ in range(header["count"])]).reshape(-1, len(names))
            found.append((header, names, rows))
    return found


def test_ovito(run):
    exported(run, "--to", "ovito")
    grains, contacts = (snapshots(run.out / f"export/ovito/{name}.dump") for name in ("grains", "contacts"))
    assert [header["time"] for header, _, _ in grains] == [*run.frames, run.time]
    assert [header["step"] for header, _, _ in contacts] == [header["step"] for header, _, _ in grains]
    header, names, rows = grains[-1]
    column = {name: rows[:, k] for k, name in enumerate(names)}
    found = run.found
    assert (column["id"] == found["/grains/id"] + 1).all() and (column["type"] == found["/grains/material"] + 1).all()
    assert (np.stack([column["x"], column["y"]], 1) == found["/grains/position"]).all()
    assert (np.stack([column["vx"], column["vy"]], 1) == found["/grains/velocity"]).all()
    assert (column["radius"] == found["/grains/radius"]).all() and (column["mass"] == found["/grains/mass"]).all()
    flags, bounds = header["box"]
    if "periodic" in str(run.path):
        assert flags == ["pp", "ff", "pp"] and bounds[0] == [-8.0, 8.0]
    else:
        assert flags == ["ff", "ff", "pp"] and bounds[0][0] <= found["/grains/position"][:, 0].min()
    _, names, rows = contacts[-1]
    with_grains = found["/contacts/grains"][:, 1] >= 0
    assert names[:3] == ["index", "batom1", "batom2"]
    assert (rows[:, 1:3] == found["/contacts/grains"][with_grains] + 1).all()
    assert (rows[:, names.index("force")] == found["/contacts/normal_force"][with_grains]).all()


def test_csv_holds_every_table(run):
    said = exported(run, "--to", "csv", "--out", "tables")
    files = {line.split("/")[-1] for line in said.splitlines()}
    assert files == {p.name for p in (run.path / "tables").iterdir()}
    assert {"grains.csv", "contacts.csv", "series.csv", "analysis_surface.csv"} <= files
    for name in ("grains", "series"):
        lines = (run.path / f"tables/{name}.csv").read_text().splitlines()
        notes = [line for line in lines if line.startswith("#")]
        header, *body = (line.split(",") for line in lines if not line.startswith("#"))
        for column, name_of in enumerate(header):
            original = run.found.get(f"/{name}/{name_of}")
            if original is None:  # a column of several
                whole, _, part = name_of.rpartition("_")
                original = run.found[f"/{name}/{whole}"][:, "xy".index(part) if part in "xy" else int(part)]
            assert [float(row[column]) for row in body] == original.tolist(), name_of
        assert any("[L] centre" in note for note in notes) or name == "series"


def test_only_the_last_state(run):
    exported(run, "--to", "vtk", "--frames", "last", "--out", "last")
    assert sorted(p.name for p in (run.path / "last").iterdir()) == [
        "contacts.pvd", "contacts_000000.vtp", "grains.pvd", "grains_000000.vtp"]


def test_exports_of_nothing(lab):
    """A run without grains in contact, of one grain."""
    lab.run("[[grain]]\nposition = [0.0, 5.0]\n[stop]\ntime = 0.1\n")
    for kind in ("vtk", "ovito", "csv"):
        assert lab("export", "out", "--to", kind).returncode == 0
    data, points, *_ = vtp(lab.path / "out/export/vtk/contacts_000000.vtp")
    assert data.GetNumberOfLines() == 0 and len(points) == 0


def test_wrong_orders(lab):
    out = lab.run("[[grain]]\nposition = [0.0, 5.0]\n[stop]\ntime = 0.1\n")
    lab.refused("export", "nowhere", "--to", "vtk", parts=["nowhere: no such folder"])
    lab.refused("export", "out", "--to", "obj", parts=["--to"])
    lab.refused("export", "out", "--to", "vtk", "--out", "out/run.h5", parts=["out/run.h5"])
    content = (out / "run.h5").read_bytes()
    (out / "run.h5").write_bytes(content[:-1])
    lab.refused("export", "out", "--to", "csv", parts=["out/run.h5: damaged"])
    assert "export" not in everything_in(out)
