# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Grains and numbers from files of other programs: what is read, what `repose check` says of it, what is refused."""

import gzip
import math

import h5py
import numpy as np
import pytest
from conftest import Grains, number_in, repose, summary

# Without gravity nothing moves in the single step of a run, so that its end is what was read.
STILL = "gravity = 0\n[method]\ntime_step = 1e-9\n[contact]\nnormal = { law = 'hooke', stiffness = 1e4 }\n[stop]\ntime = 1e-9\n"


def start(name, more="", rest=STILL):
    return rest.replace("[contact]", f"[start]\nfrom = '{name}'\n{more}[contact]", 1)


def written(lab, name, content):
    if isinstance(content, bytes):
        (lab.path / name).write_bytes(content)
    else:
        (lab.path / name).write_text(content)


def checked(lab, name, content, more="", rest=STILL):
    written(lab, name, content)
    result = lab("check", lab.scene(start(name, more, rest)))
    assert result.returncode == 0, result.stderr
    return result.stdout


def read(lab, name, content, more="", rest=STILL):
    written(lab, name, content)
    return Grains(lab.run(start(name, more, rest), "--overwrite") / "run.h5")


def refused(lab, name, content, *parts, more="", rest=STILL):
    written(lab, name, content)
    return lab.refused("check", lab.scene(start(name, more, rest)), parts=parts)


ONE = [[0.0, 1.0]]
TWO = [[0.0, 1.0], [2.0, 1.0]]
TABLES = {
    "space.txt": ("x y radius\n0 1 0.5\n2 1 0.5\n", TWO),
    "hashheader.txt": ("# x y radius\n0 1 0.5\n2 1 0.5\n", TWO),
    "percent.txt": ("% x y radius\n0 1 0.5\n2 1 0.5\n", TWO),
    "semi_deccomma.csv": ("x;y;radius\n0,0;1,0;0,5\n2,0;1,0;0,5\n", TWO),
    "tab_deccomma.txt": ("x\ty\tradius\n0,0\t1,0\t0,5\n2,0\t1,0\t0,5\n", TWO),
    "fortran.csv": ("x,y,radius\n0.0D+00,1.0D+00,5.0D-01\n", ONE),
    "savetxt.txt": ("# x y radius\n0.000000000000000000e+00 1.000000000000000000e+00 5.000000000000000000e-01\n", ONE),
    "pandas_bool.csv": (",x,y,radius,fixed\n0,0,1,0.5,True\n1,2,1,0.5,False\n", TWO),
    "float_ids.csv": ("id,x,y,radius\n2.0,2,1,0.5\n1.0,0,1,0.5\n", TWO),
    "upper.csv": ("X,Y,Radius\n0,1,0.5\n", ONE),
    "r.csv": ("id,x,y,r\n1,0,1,0.5\n", ONE),
    "diameter.csv": ("x,y,D\n0,1,1\n", ONE),
    "extra_z.csv": ("x,y,z,radius\n0,1,0,0.5\n", ONE),
    "trailing.csv": ("x,y,radius,\n0,1,0.5,\n", ONE),
    "mac.csv": ("x,y,radius\r0,1,0.5\r", ONE),
    "windows.csv": (b"\xef\xbb\xbfx,y,radius\r\n0,1,0.5\r\n", ONE),
    "utf16.csv": ("x,y,radius\r\n0,1,0.5\r\n".encode("utf-16"), ONE),
    "utf16be.csv": ("x,y,radius\n0,1,0.5\n".encode("utf-16-be"), ONE),
    "z.csv.gz": (gzip.compress(b"x,y,radius\n0,1,0.5\n"), ONE),
    "ext.xyz": (
        '2\nLattice="20 0 0 0 20 0 0 0 1" Properties=species:S:1:pos:R:3:radius:R:1 Time=0\nA 0 1 0 0.5\nA 2 1 0 0.5\n',
        TWO,
    ),
    "packing.dump.gz": (
        gzip.compress(
            b"ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS ff ff pp\n-9 9\n0 9\n-0.5 0.5\n"
            b"ITEM: ATOMS id type x y radius\n1 1 0 1 0.5\n"
        ),
        ONE,
    ),
    "yade.txt": ("#format x_y_z_r\n0\t1\t0\t0.5\n2\t1\t0\t0.5\n", TWO),
    "mercury.data": ("1 0 -5 0 5 9\n0 1 0 0 0.5 0 0 0\n", ONE),
    "data.lammps": ("# by hand\n\n1 atoms\n1 atom types\n-5 5 xlo xhi\n0 9 ylo yhi\n\nAtoms # sphere\n\n1 1 1 1 0 1 0\n", ONE),
}


@pytest.mark.parametrize("name", TABLES)
def test_tables_are_read(lab, name):
    content, places = TABLES[name]
    grains = read(lab, name, content)
    assert grains.position.tolist() == places
    assert (grains.radius == 0.5).all()
    again = lab("run", "out/scene.toml", "--out", "again", "--quiet")
    assert again.returncode == 0, again.stderr
    assert summary(lab.path / "again")["state_hash"] == summary(lab.path / "out")["state_hash"]


def test_fixed_by_words(lab):
    assert read(lab, "pandas.csv", TABLES["pandas_bool.csv"][0]).fixed.tolist() == [1, 0]


def test_columns_are_named(lab):
    text = checked(lab, "forces.csv", "id,x,y,radius,fx,fy\n1,0,1,0.5,0,0\n")
    assert "columns used: id, x, y, radius\n" in text
    assert "columns left out: fx, fy\n" in text
    assert "column 1 (without a name)" in checked(lab, "pandas.csv", TABLES["pandas_bool.csv"][0])


DUMP = "ITEM: TIMESTEP\n{step}\nITEM: NUMBER OF ATOMS\n{count}\nITEM: BOX BOUNDS {box}-0.5 0.5\nITEM: ATOMS {rows}"


def dump(rows, box="pp ff pp\n0 10\n0 10\n", step=0, head=""):
    return head + DUMP.format(step=step, count=rows.count("\n") - 1, box=box, rows=rows)


ACROSS = dump("id type x y radius\n1 1 0.4 1 0.5\n2 1 9.6 1 0.5\n")
PERIODIC = "[box]\nx = 'periodic'\nhalf_width = {}\n[contact]"


def test_check_describes_a_dump(lab):
    text = checked(lab, "pp.dump", ACROSS)
    for part in (
        "LAMMPS dump, snapshot 0\n",
        "columns used: id, type, x, y, radius\n",
        "units: the file gives none",
        "box of the file: x 0 to 10 (periodic), y 0 to 10 (open)\n",
        "centres: x 0.4 to 9.6, y 1 to 1\n",
        "diameters: 1; masses: 1, by the scene\n",
        "deepest overlap: none\n",
        "warning          start.from: the file's box is periodic along x, 10 wide, the scene's is not",
    ):
        assert part in text, part


# The two grains lie 0.8 apart through the side of a box 10 wide, wherever it begins: they overlap by 0.2, one contact. In a
# wider box they do not touch.
def test_wrapping(lab):
    periodic = STILL.replace("[contact]", PERIODIC.format(5))
    text = checked(lab, "pp.dump", ACROSS, rest=periodic)
    assert "deepest overlap: 0.2 of the mean diameter, grains 1 and 2 (lines 10 and 11)" in text
    assert text.count("warning") == 1 and "grains 1 and 2 (lines 10 and 11) overlap by 0.2 of their mean diameter" in text
    for shift in ("0.0, 0.0", "-5.0, 0.0", "100.0, 2.0"):
        out = lab.run(start("pp.dump", f"shift = [{shift}]\n", rest=periodic), "--overwrite")
        with h5py.File(out / "run.h5", "r") as file:
            assert file["contacts/grains"][()].tolist() == [[0, 1]]
            assert abs(file["grains/position"][()][:, 0]).max() <= 5
    wrapped = read(lab, "pp.dump", ACROSS, rest=periodic)
    assert wrapped.position[:, 0] == pytest.approx([0.4, -0.4], abs=1e-6)
    wider = checked(lab, "pp.dump", ACROSS, rest=STILL.replace("[contact]", PERIODIC.format(6)))
    assert "warning          start.from: the file's box is 10 wide, the scene's 12\n" in wider
    assert "deepest overlap: none" in wider


SI_DUMP = dump("id type x y radius\n1 1 0.001 0.001 0.0005\n", step=10, head="ITEM: UNITS\nsi\n")
SI = "units = 'SI'\n[method]\ntime_step = 1e-9\n[grains]\ndiameter = 1e-3\nmass = 1e-6\n[contact]\nnormal = { law = 'hooke', stiffness = 10 }\n[stop]\ntime = 1e-9\n"


def test_units_that_contradict(lab):
    refused(lab, "d_si.dump", SI_DUMP, "the file has units si, the scene reduced (d, m and g are 1): set start.scale to relate their lengths, or units = \"SI\"")
    scaled = read(lab, "d_si.dump", SI_DUMP, "scale = 1000\n")
    assert scaled.position.tolist() == [[1.0, 1.0]] and scaled.radius.tolist() == [0.5]
    assert "units: si, those of the scene SI\n" in checked(lab, "d_si.dump", SI_DUMP, rest=SI)
    text = checked(lab, "mm.csv", "x (mm),y (mm),d (mm)\n0,1,1\n")
    assert "warning          start.from: the file has units mm, the scene reduced (d, m and g are 1): its numbers are taken as" in text
    assert read(lab, "mm.csv", "x (mm),y (mm),d (mm)\n0,1,1\n").position.tolist() == ONE
    refused(lab, "m.csv", "x (m),y (m),d (m)\n0,1,0.001\n", "the file has units m, the scene reduced")
    in_metres = read(lab, "mm.csv", "x (mm),y (mm),d (mm),vx (mm/s),mass (mg)\n2,1,1,5,2\n", rest=SI)
    assert in_metres.position[0, 1] == pytest.approx(1e-3, rel=1e-6)
    assert in_metres.radius[0] == pytest.approx(5e-4, rel=1e-15)
    assert in_metres.mass[0] == pytest.approx(2e-6, rel=1e-15)
    assert in_metres.velocity[0, 0] == pytest.approx(5e-3, rel=1e-12)
    lj = SI_DUMP.replace("si\n", "lj\n", 1).replace("0.0005", "0.5")
    refused(lab, "lj.dump", lj, "the file has units reduced, the scene SI", rest=SI)
    small = checked(lab, "small.csv", "x,y,radius\n0,0.01,0.0025\n")
    assert "warning          start.from: diameters of 0.005 are far from grains.diameter = 1" in small


def test_masses_that_differ(lab):
    text = checked(lab, "heavy.csv", "x,y,radius,mass\n0,1,0.5,7\n")
    assert "masses: 7, by the file" in text
    assert "warning          start.from: masses in the file are 7 times" in text


def test_deep_overlaps_are_named(lab):
    assert "deepest overlap: 0.24" in checked(lab, "allowed.csv", "x,y,radius\n0,1,0.5\n0.76,1,0.5\n")
    refused(lab, "beyond.csv", "x,y,radius\n0,1,0.5\n0.74,1,0.5\n", "overlap by 0.26 of their mean diameter; at most 0.25")
    refused(lab, "overlap.csv", "x,y,radius\n0,1,0.5\n0.3,1,0.5\n3,1,0.5\n",
            "overlap.csv: the grains of lines 2 and 3 overlap by 0.7 of their mean diameter")
    refused(lab, "duppos.csv", "id,x,y,radius\n7,0,1,0.5\n9,0,1,0.5\n5,3,1,0.5\n",
            "grains 7 and 9 (lines 2 and 3) lie at the same place")
    grain = "[[grain]]\nposition = [0.5, 1.0]\n"
    refused(lab, "one.csv", "x,y,radius\n0,1,0.5\n", "grain[0].position = [0.5, 1]: it and the grain of line 2 of start.from "
            "overlap by 0.5", rest=STILL + grain)
    many = "x,y,radius\n" + "0,1,0.5\n" * 7
    assert "and 13 more pairs of grains overlap" in refused(lab, "many.csv", many)


@pytest.mark.parametrize("method", ["soft", "contact-dynamics"])
def test_placed_grains_that_coincide(lab, method):
    scene = f"[method]\nkind = '{method}'\n[[grain]]\nposition = [0.0, 0.0]\nfixed = true\n[[grain]]\nposition = [{{}}, 0.0]\n[stop]\ntime = 0.2\n"
    lab.refused("check", lab.scene(scene.format(0.0)), parts=("scene.toml:7: grain[1].position = [0, 0]: it and grain[0] lie at the same place",))
    lab.refused("run", lab.scene(scene.format(0.5)), parts=("it and grain[0] overlap by 0.5 of their mean diameter",))
    assert lab("check", lab.scene(scene.format(0.8))).returncode == 0


def test_third_axis(lab):
    noise = dump("id type x y z radius\n1 1 1 1 1e-19 0.5\n2 1 3 1 -3e-20 0.5\n")
    assert read(lab, "d_znoise.dump", noise).position.tolist() == [[1, 1], [3, 1]]
    far = "x,y,z,radius\n0,1,0.1,0.5\n2,1,0.3,0.5\n"
    refused(lab, "far.csv", far, "far.csv:3: z = 0.3: must be the same for all grains within start.tolerance = 1e-06 (0.1 in line 2)")
    assert read(lab, "far.csv", far, "tolerance = 0.25\n").position.tolist() == TWO


def test_planes(lab):
    text = "x,y,z,radius,vz\n0,5,1,0.5,-1\n2,5,1,0.5,0\n"
    refused(lab, "xz.csv", text.replace("y", "w"), 'for these set start.plane = "xz"')
    grains = read(lab, "xz.csv", text, "plane = 'xz'\n")
    assert np.allclose(grains.position, TWO) and grains.velocity[0].tolist() == [0, -1]
    yz = read(lab, "yz.csv", "x,y,z,radius\n7,0,1,0.5\n7,2,1,0.5\n", "plane = 'yz'\n")
    assert yz.position.tolist() == TWO


# Places are scaled, then mirrored, then shifted; a mirror changes the sense of a spin, two mirrors do not.
def test_scale_flip_and_shift(lab):
    text = "x,y,radius,vx,vy,spin\n1,2,0.25,0.5,-0.25,3\n"
    grains = read(lab, "moved.csv", text, "scale = 2\nflip = 'y'\nshift = [10, 20]\n")
    assert grains.position[0] == pytest.approx([12, 16], rel=1e-7)
    assert grains.radius.tolist() == [0.5]
    assert grains.velocity[0] == pytest.approx([1, 0.5])
    assert grains.spin[0] == pytest.approx(-3)
    both = read(lab, "moved.csv", text, "flip = 'both'\n")
    assert both.position[0] == pytest.approx([-1, -2], rel=1e-7)
    assert both.spin[0] == pytest.approx(3)


def test_fixed_types(lab):
    text = dump("id type x y radius\n1 1 1 1 0.5\n2 2 3 1 0.5\n3 3 5 1 0.5\n", box="ff ff pp\n0 10\n0 10\n")
    grains = read(lab, "types.dump", text, "fixed_types = [2, 3]\n")
    assert grains.fixed.tolist() == [0, 1, 1]
    assert "the file has grains of 3 types, the scene one material" in checked(lab, "types.dump", text)
    refused(lab, "types.dump", text, "no grain is of type 4, which start.fixed_types names; there are 1, 2, 3", more="fixed_types = [4]\n")


def test_materials_by_name(lab):
    text = "x,y,radius,material\n0,1,0.5,glass\n2,1,0.5,steel\n"
    materials = "[[material]]\nname = 'steel'\n[[material]]\nname = 'glass'\ndensity = 2\n"
    grains = read(lab, "named.csv", text, rest=STILL + materials)
    assert grains.material.tolist() == [1, 0] and grains.mass.tolist() == [2, 1]
    refused(lab, "wood.csv", text.replace("glass", "wood"), "has grains of wood, which is no [[material]] of the scene; they are steel, glass",
            rest=STILL + materials)
    numbered = "x,y,radius,material\n0,1,0.5,0\n2,1,0.5,2\n"
    refused(lab, "three.csv", numbered, "are of materials that this scene has not", rest=STILL + materials)


def test_unknown_formats(lab):
    refused(lab, "old.vtk", "# vtk DataFile Version 3.0\nx\nASCII\n", "is a legacy VTK file; open it in ParaView")
    refused(lab, "packed.csv.bz2", b"BZh91AY&SY", "is packed by bzip2; unpack it")
    refused(lab, "plain.xyz", "1\nno radii\nA 0 1 0\n", "is an XYZ file without radii; write extended XYZ")


# Grains of 0.3 alone: the step goes with the root of the mass over the stiffness, so with their size, 0.3 times that of
# grains of 1. The nominal size has no grain, so the sizes do not differ and velocities stay those of the half-step. The
# fall is that of the height 1 in both scenes.
def test_sizes_that_exist(lab):
    law = "[contact]\nnormal = { law = 'hooke', stiffness = 1e4, restitution = 0.5 }\n[stop]\ntime = 1\n"
    small = checked(lab, "small.csv", "x,y,diameter\n0,1,0.3\n1,1,0.3\n", rest=law)
    usual = checked(lab, "usual.csv", "x,y,diameter\n0,1,1\n1,1,1\n", rest=law)
    assert "diameters 0.3 to 0.3" in small
    assert "synchronised" not in small
    steps = [number_in(text, "time step") for text in (small, usual)]
    assert steps[0] == pytest.approx(0.3 * steps[1], rel=1e-3), "as many digits as are printed"
    assert "grains of 0.3 that meet at" in small


# A grain of a quarter of the usual mass has half the step, one that is heavier has the larger one.
def test_masses_that_exist(lab):
    law = "[contact]\nnormal = { law = 'hooke', stiffness = 1e4, restitution = 0.5 }\n[stop]\ntime = 1\n"
    steps = {
        mass: number_in(checked(lab, "m.csv", f"x,y,diameter,mass\n0,1,1,{mass}\n", rest=law), "time step")
        for mass in (0.25, 1, 4)
    }
    assert steps[0.25] == pytest.approx(steps[1] / 2, rel=1e-3), "as many digits as are printed"
    assert steps[4] == pytest.approx(steps[1] * 2, rel=1e-3)


# A grain at rest carries its own weight, which is the unit of force of a scene without grains of the nominal size.
def test_unit_of_force(lab):
    law = (
        "[base]\nkind = 'plane'\n[contact]\nnormal = { law = 'hooke', stiffness = 1e3, restitution = 0.1 }\n"
        "[output]\nwindow = 1\n[stop]\nat_rest = 1e-9\ntime = 100\n"
    )
    written(lab, "small.csv", "x,y,diameter\n0,0.15,0.3\n")
    out = lab.run(start("small.csv", rest=law))
    weight = 0.3**2
    assert Grains(out / "run.h5").mass[0] == pytest.approx(weight, rel=1e-15)
    with h5py.File(out / "run.h5", "r") as file:
        assert file.attrs["grain_weight"] == pytest.approx(weight, rel=1e-12)


COLUMN = "height,apparent_mass{}\n1,0.9{}\n2,1.6{}\n4,2.5{}\n8,3.0{}\n"


@pytest.mark.parametrize("name", ["apparent_mass_error", "error", "sigma", "Sigma (kg)", "uncertainty"])
def test_errors_of_a_fit(tmp_path, name):
    file = tmp_path / "column.csv"

    def fit(text):
        file.write_text(text)
        result = repose("theory", "janssen-fit", "--set", f"file={file}", "--set", "mass_per_height=1")
        assert result.returncode == 0, result.stderr
        return result.stdout

    weighted = fit(COLUMN.format("," + name, ",0.01", ",0.02", ",0.05", ",0.5"))
    plain = fit(COLUMN.format(",note", ",0.01", ",0.02", ",0.05", ",0.5"))
    assert f"# note errors of the masses: column {name.split(' (')[0]}\n" in weighted
    assert "# note columns left out: note\n" in plain
    assert not math.isclose(number_in(weighted, "lambda_2 ="), number_in(plain, "lambda_2 ="), rel_tol=1e-3)
    semicolons = COLUMN.format(";" + name, ";0,01", ";0,02", ";0,05", ";0,5").replace(",apparent", ";apparent")
    for height in (1, 2, 4, 8):
        semicolons = semicolons.replace(f"\n{height},", f"\n{height};").replace("0.9", "0,9").replace("1.6", "1,6")
    assert fit(semicolons).split("# result")[1:] == weighted.split("# result")[1:]
