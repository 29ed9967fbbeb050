# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Exports, read back by VTK, by a short reader of LAMMPS dumps, and as tables."""

import csv
import re
import shutil
import subprocess
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
    _, _, ends_of_lines, _ = vtp(out / f"contacts_{last}")  # the filter Tube asks for arrays of points
    assert (ends_of_lines["normal_force"].reshape(-1, 2) == contacts["normal_force"][:, None]).all()
    # The length of a line is the distance of the centres, also across a periodic side, or the radius at a wall.
    ends = points.reshape(-1, 2, 3)
    radius = dict(zip(found["/grains/id"], found["/grains/radius"]))
    rigid = np.array([radius[i] + (radius[j] if j >= 0 else 0.0) for i, j in found["/contacts/grains"]])
    beside = np.where(found["/contacts/grains"][:, 1] >= 0, found["/contacts/overlap"], 0.0)
    assert np.allclose(np.hypot(*(ends[:, 0] - ends[:, 1])[:, :2].T), rigid - beside, atol=1e-12)
    assert np.allclose(contacts["force"][:, :2], found["/contacts/normal_force"][:, None] * found["/contacts/normal"]
                       + found["/contacts/tangential_force"][:, None] * found["/contacts/normal"][:, ::-1] * [-1, 1])


def test_vtk_walls_and_fields(run):
    exported(run, "--to", "vtk")
    out = run.out / "export/vtk"
    if "/walls/name" in run.found:
        data, points, _, cells = vtp(sorted(out.glob("walls_*.vtp"))[-1])
        assert data.GetNumberOfLines() == len(run.found["/walls/name"]) == len(set(cells["wall"]))
        ends = points.reshape(-1, 2, 3)[:, :, :2]
        place, normal = run.found["/walls/position"], run.found["/walls/normal"]
        assert np.allclose(np.einsum("wed,wd->we", ends - place[:, None], normal), 0.0, atol=1e-12)
    else:
        assert not list(out.glob("walls*"))
    vtk = pytest.importorskip("vtkmodules.vtkIOXML")
    from vtkmodules.util.numpy_support import vtk_to_numpy

    reader = vtk.vtkXMLImageDataReader()
    reader.SetFileName(str(out / "fields.vti"))
    reader.Update()
    image, x, y = reader.GetOutput(), run.found["/analysis/fields/x"], run.found["/analysis/fields/y"]
    assert image.GetDimensions() == (len(x) + 1, len(y) + 1, 1)
    cell = image.GetSpacing()[0]
    assert image.GetOrigin()[:2] == pytest.approx((x[0] - cell / 2, y[0] - cell / 2))
    values = vtk_to_numpy(image.GetCellData().GetArray("stress_yy")).reshape(len(y), len(x))
    assert (values == run.found["/analysis/fields/stress_yy"]).all()


def test_a_deposition_has_no_forces_to_export(lab):
    lab.run("method = { kind = 'deposition', critical_angle = 50 }\nbase = { kind = 'contiguous', count = 12 }\n"
            "source = { count = 60 }\n")
    exported(lab, "--to", "vtk")
    exported(lab, "--to", "csv")
    _, _, _, contacts = vtp(next((lab.path / "out/export/vtk").glob("contacts_*.vtp")))
    assert set(contacts) == {"grains", "overlap"}
    _, columns = table(lab.path / "out/export/csv/contacts.csv")
    assert not any("force" in name or name in ("history", "sliding", "rolling") for name in columns)


def test_attributes_are_text_and_units_are_those_of_the_scene(lab):
    out = lab.run("units = 'SI'\ngravity = 9.81\n[grains]\ndiameter = 0.005\nmass = 5e-4\n[contact]\nnormal = { law = 'hooke', "
                  "stiffness = 1e4, damping = 0.5 }\n[base]\nkind = 'plane'\n[[grain]]\nposition = [0, 0.0025]\n[stop]\ntime = 0.02\n")
    with h5py.File(out / "run.h5") as file:
        assert file.attrs["units"] == "SI" and isinstance(file.attrs["title"], str)
        assert file["grains"].attrs["units"] == "SI" and file["grains/velocity"].attrs["unit"] == "m/s"
        assert file["contacts/normal_force"].attrs["unit"] == "kg m/s^2" and file["grains/id"].attrs["unit"] == ""
        assert file["contacts/point"][0] == pytest.approx([0.0, 0.0], abs=1e-5)


def snapshots(path):
    """[(header items, column names, rows)] of a LAMMPS dump."""
    found, lines = [], iter(path.read_text().splitlines())
    header = {}
    for line in lines:
        item = line.removeprefix("ITEM: ")
        if item == "TIME":  # LAMMPS writes it first, and reads it nowhere else
            header = {"time": float(next(lines))}
        elif item == "TIMESTEP":
            assert header.keys() == {"time"}
            header["step"] = int(next(lines))
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


# LAMMPS reads the last snapshot of a dump and writes it again with all digits.
def test_lammps_reads_the_dump(run):
    exported(run, "--to", "ovito", "--out", "dump")
    dump = run.path / "dump/grains.dump"
    last = snapshots(dump)[-1]
    (run.path / "in.lammps").write_text(f"""units lj
dimension 2
boundary f f p
atom_style sphere
region all block -100 100 -100 100 -0.5 0.5
create_box 1 all
read_dump {dump} {last[0]["step"]} x y vx vy box yes add yes
write_dump all custom back.dump id x y vx vy modify sort id format float %.17g
""")
    result = subprocess.run(["lmp", "-in", "in.lammps", "-log", "none"], cwd=run.path, capture_output=True, text=True)
    assert result.returncode == 0, result.stdout + result.stderr
    lines = (run.path / "back.dump").read_text().splitlines()
    start = next(k for k, line in enumerate(lines) if line.startswith("ITEM: ATOMS")) + 1
    back = np.array([[float(x) for x in line.split()] for line in lines[start:]])
    assert (back[:, 0] == run.found["/grains/id"] + 1).all()
    assert np.allclose(back[:, 1:3], run.found["/grains/position"], rtol=0, atol=1e-13)
    assert np.allclose(back[:, 3:5], run.found["/grains/velocity"], rtol=1e-15, atol=1e-15)


# ASE reads the dump, writes extended XYZ with radii and velocities, and a run starts from that file as from the run.
def test_there_and_back_through_ase(run):
    io = pytest.importorskip("ase.io")
    exported(run, "--to", "ovito", "--out", "for-ase")
    atoms = io.read(run.path / "for-ase/grains.dump", index=-1, format="lammps-dump-text")
    found = run.found
    order = np.argsort(found["/grains/id"])
    assert len(atoms) == len(order)
    np.testing.assert_array_equal(atoms.get_positions()[:, :2], found["/grains/position"][order])
    atoms.set_array("radius", found["/grains/radius"][order])
    velocity = np.linspace([0.0, 0.3], [0.2, -0.1], len(order))
    atoms.set_array("velocity", np.pad(velocity, ((0, 0), (0, 1))))
    io.write(run.path / "back.xyz", atoms, format="extxyz", columns=["symbols", "positions", "radius", "velocity"])
    again = run.run(f"[start]\nfrom = 'back.xyz'\n[grains]\ndiameter = {2 * float(found['/grains/radius'][0])!r}\n"
                    "[stop]\ntime = 1e-9\n[output]\nframes = 0\n", "--set", "method.time_step=1e-9", out="again")
    first = datasets(again / "run.h5")
    # ASE writes eight decimals.
    np.testing.assert_allclose(first["/grains/position"], found["/grains/position"][order], rtol=0, atol=2e-8)
    np.testing.assert_allclose(first["/grains/radius"], found["/grains/radius"][order], rtol=0, atol=1e-8)
    np.testing.assert_allclose(first["/grains/velocity"], velocity, rtol=0, atol=1e-5)  # forces have acted for 1e-9


def table(path):
    """(lines that begin with #, columns by name) of an exported table, quoted cells included."""
    lines = path.read_text().splitlines()
    notes = [line for line in lines if line.startswith("#")]
    names, *body = csv.reader(line for line in lines if not line.startswith("#"))
    assert len(set(names)) == len(names) and all(len(row) == len(names) for row in body)
    return notes, {name: [row[k] for row in body] for k, name in enumerate(names)}


def parts(run, group, name, width):
    """The names of the columns of a dataset with several columns."""
    if group == "series":
        return [f"{name}_{wall.decode()}" for wall in run.found["/walls/name"]]
    if width == 2:
        return [f"{name}_{k}" for k in (("first", "second") if name == "grains" else "xy")]
    return [f"{name}_{k}" for k in range(width)]


def test_csv_holds_every_table(run):
    said = exported(run, "--to", "csv", "--out", "tables")
    files = {line.split("/")[-1] for line in said.splitlines()}
    assert files == {p.name for p in (run.path / "tables").iterdir()}
    seen = set()
    frames = {file for file in files if file.startswith("frame_")}
    assert frames == {f"frame_{k:06}_{name}.csv" for k in range(len(run.frames)) for name in ("grains", "contacts")}
    _, last = table(run.path / "tables" / f"frame_{len(run.frames) - 1:06}_grains.csv")
    with h5py.File(run.out / f"frames/{len(run.frames) - 1:06}.h5") as file:
        assert [float(x) for x in last["position_x"]] == file["grains/position"][:, 0].tolist()
    for file in files - frames:
        notes, columns = table(run.path / "tables" / file)
        group = notes[0].split()[1]
        prefix = f"/analysis/{group}/" if file.startswith("analysis_") else f"/{group}/"
        described = [found[1] for line in notes if (found := re.match(r"# (\w+):", line))]
        left = set(columns)
        for name in described:
            original = run.found[prefix + name]
            seen.add(prefix + name)
            if group == "fields":  # a row for each cell, y by y
                x, y = run.found[prefix + "x"], run.found[prefix + "y"]
                original = {"x": np.tile(x, len(y)), "y": np.repeat(y, len(x))}.get(name, original.reshape(-1))
            names = [name] if original.ndim == 1 else parts(run, group, name, original.shape[1])
            for one, values in zip(names, original.reshape(len(original), -1).T):
                if values.dtype.kind == "S":
                    assert columns[one] == [value.decode() for value in values]
                else:
                    np.testing.assert_array_equal(np.array(columns[one], dtype=values.dtype), values, err_msg=f"{file}: {one}")
                left.remove(one)
        assert not left, f"{file}: {left} are described nowhere"
    tables = {name for name, value in run.found.items() if value.ndim and not name.startswith(("/frames/", "/track/"))}
    assert {name for name in tables if name.count("/") > 1} == seen


def test_csv_states_units_and_settings(run):
    exported(run, "--to", "csv", "--out", "units")
    notes, columns = table(run.path / "units/grains.csv")
    assert next(iter(columns)) == "id" and "# position: [L] centre" in notes
    notes, columns = table(run.path / "units/analysis_surface.csv")
    assert next(iter(columns)) == "x" and "# bin_width = 2" in notes


def test_only_the_last_state(run):
    exported(run, "--to", "vtk", "--frames", "last", "--out", "last")
    walls = ["walls.pvd", "walls_000000.vtp"] if "/walls/name" in run.found else []
    assert sorted(p.name for p in (run.path / "last").iterdir()) == [
        "contacts.pvd", "contacts_000000.vtp", "fields.vti", "grains.pvd", "grains_000000.vtp", *walls]


def test_exports_without_contacts(lab):
    """A run of one grain without contacts."""
    lab.run("[[grain]]\nposition = [0.0, 5.0]\n[stop]\ntime = 0.1\n")
    for kind in ("vtk", "ovito", "csv"):
        assert lab("export", "out", "--to", kind).returncode == 0
    data, points, *_ = vtp(lab.path / "out/export/vtk/contacts_000000.vtp")
    assert data.GetNumberOfLines() == 0 and len(points) == 0


def test_a_second_export_replaces_the_first(lab):
    """Files of an earlier, longer series are removed; files that are not exports stay."""
    out = lab.run(SCENES["heap"])
    vtk = out / "export/vtk"
    exported(lab, "--to", "vtk")
    assert len(list(vtk.glob("grains_*.vtp"))) > 3
    (vtk / "view.pvsm").write_text("mine")
    exported(lab, "--to", "vtk", "--frames", "last")
    assert sorted(p.name for p in vtk.iterdir()) == [
        "contacts.pvd", "contacts_000000.vtp", "fields.vti", "grains.pvd", "grains_000000.vtp", "view.pvsm"]
    exported(lab, "--to", "vtk", "--quiet")
    assert len(list(vtk.glob("grains_*.vtp"))) > 3


def test_folders_that_are_not_exports_are_not_changed(lab):
    lab.run(SCENES["heap"])
    (lab.path / "mine").mkdir()
    (lab.path / "mine/grains.dump").write_text("precious")
    lab.refused("export", "out", "--to", "ovito", "--out", "mine",
                parts=["mine: folder is not empty; choose another --out, or --overwrite"])
    assert (lab.path / "mine/grains.dump").read_text() == "precious"
    exported(lab, "--to", "ovito", "--out", "mine", "--overwrite")
    assert (lab.path / "mine/grains.dump").read_text().startswith("ITEM: TIME\n")


def test_a_killed_run_without_analysis(lab):
    """A killed run has frames that run.h5 does not name yet, and no analysis. Everything that it names is exported."""
    out = lab.run(SCENES["heap"])
    shutil.copy(out / "frames/000000.h5", out / "frames/000099.h5")
    (out / "analysis.h5").unlink()
    exported(lab, "--to", "vtk")
    with h5py.File(out / "run.h5") as file:
        frames = len(file["frames"])
    assert len(list((out / "export/vtk").glob("grains_*.vtp"))) == frames + 1
    assert "analysis" not in exported(lab, "--to", "csv")


@pytest.mark.parametrize("kind", ["vtk", "ovito"])
def test_missing_and_damaged_frames(lab, kind):
    out = lab.run(SCENES["heap"])
    frame = out / "frames/000002.h5"
    content = frame.read_bytes()
    frame.write_bytes(content[:-100])
    said = lab.refused("export", "out", "--to", kind, parts=["out/frames/000002.h5: damaged"])
    assert len(said.splitlines()) == 1
    frame.unlink()
    lab.refused("export", "out", "--to", kind, parts=["out/frames/000002.h5: is missing; --frames last does without"])
    exported(lab, "--to", kind, "--frames", "last")


def test_disk_full(lab):
    """A limit on the size of a file simulates it: no partial file is left, and an older export is not harmed."""
    out = lab.run(SCENES["heap"])
    before = everything_in(out)
    for kind, blocks in (("vtk", 4), ("ovito", 8), ("csv", 2)):
        result = lab("export", "out", "--to", kind, before=f"ulimit -f {blocks}")
        assert result.returncode == 1 and "cannot write: File too large" in result.stderr, result.stderr
        assert len(result.stderr.splitlines()) == 1 and ".unfinished" not in result.stderr
        assert everything_in(out) == before
    exported(lab, "--to", "ovito")
    older = (out / "export/ovito/grains.dump").read_bytes()
    assert lab("export", "out", "--to", "ovito", before="ulimit -f 8").returncode == 1
    assert (out / "export/ovito/grains.dump").read_bytes() == older
    assert sorted(p.name for p in (out / "export/ovito").iterdir()) == ["contacts.dump", "grains.dump"]


def test_grains_that_were_exported_start_a_run(run):
    """An import of an export has the same bits of positions, velocities and radii."""
    for kind, file in (("csv", "grains.csv"), ("ovito", "grains.dump")):
        exported(run, "--to", kind, "--out", f"again-{kind}")
        scene = f"again-{kind}.toml"
        box = "[box]\nx = 'periodic'\nhalf_width = 8\n" if "periodic" in str(run.path) else ""
        (run.path / scene).write_text(f"[contact]\nnormal = {{ law = 'hooke', stiffness = 5e3 }}\n[start]\nfrom = 'again-{kind}/{file}'\n{box}[stop]\ntime = 1e-3\n"
                                      "[method]\ntime_step = 1e-3\n[output]\nseries = 1e-3\n")
        out = f"started-{kind}"
        result = run("run", scene, "--out", out, "--quiet")
        assert result.returncode == 0, result.stderr
        with h5py.File(run.path / out / "run.h5") as file:
            again = {name: file[f"grains/{name}"][()] for name in ("position", "velocity", "radius", "fixed", "base", "mass")}
        for name in ("radius", "fixed", "base", "mass"):
            assert (again[name] == run.found[f"/grains/{name}"]).all(), name
        # One step later: a thousandth of the velocity and of its change by the forces.
        far = np.abs(run.found["/grains/velocity"]).max() * 1e-3 + 1e-3
        moved = np.abs(again["position"] - run.found["/grains/position"])
        assert np.minimum(moved, 16.0 - moved if box else moved).max() < far


def test_wrong_orders(lab):
    out = lab.run("[[grain]]\nposition = [0.0, 5.0]\n[stop]\ntime = 0.1\n")
    lab.refused("export", "nowhere", "--to", "vtk", parts=["nowhere: no such folder"])
    lab.refused("export", "out", "--to", "obj", parts=["--to"])
    lab.refused("export", "out", "--to", "vtk", "--out", "out/run.h5", parts=["out/run.h5"])
    content = (out / "run.h5").read_bytes()
    (out / "run.h5").write_bytes(content[:-1])
    lab.refused("export", "out", "--to", "csv", parts=["out/run.h5: damaged"])
    assert "export" not in everything_in(out)
