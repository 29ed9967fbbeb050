# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Reads analysis.h5 of a run folder; the format is described in docs/reference/analysis.md."""

import h5py

from repose.hdf5 import Table, attributes_of, check_format, opened

FORMAT_VERSION = 1
GROUPS = {
    "surface": "x height used",
    "base": "x count normal normal_error shear shear_error",
    "force_range": "x min max",
    "voronoi": "id area solid_fraction closed offset vertices",
    "forces": "f density error direction_deg direction_all direction_strong",
    "chains": "contacts grains direction_deg extent chain",
    "force_lines": "id strongest weakest strongest_force weakest_force",
    "stability": "id displacement",
    "column": "depth bottom top pressure shear stress load",
    "column_motion": "time floor top shortening front",
    "drive": "time force displacement",
    "slips": "begin end force drop slide waiting creep",
    "fields": "x y room density solid_fraction stress_xx stress_xy stress_yx stress_yy support_x support_y velocity_x "
    "velocity_y temperature contacts fabric_xx fabric_xy fabric_yy coordination",
    "walls": "name length pressure shear moment",
    "grain_stress": "id area in_cell stress_xx stress_xy stress_yx stress_yy",
    "motion": "start end grains moved moved_left depth kinetic_energy angle_left angle_right",
    "avalanches": "start end size duration waiting depth left",
    "bursts": "start end duration waiting peak",
}  # needed datasets by group, in two dimensions
SPHERE_GROUPS = {
    "cone_surface": "r height sector_height used",
    "cone_sectors": "azimuth_deg angle_deg",
    "base_rings": "r inner outer count pressure pressure_error shear shear_error load",
    "base_cells": "x y count pressure shear_x shear_y",
    "axial_fields": "r z density solid_fraction stress_rr stress_tt stress_zz stress_rz",
    "forces": "f density error direction_cosine direction_all direction_strong",
    "chains": "contacts grains chain",
    "pair_correlation": "r g error",
    "structure_factor": "q s error",
    "voronoi": "id volume solid_fraction closed",
    "column": GROUPS["column"],
    "motion": "start end moved depth",
    "avalanches": "start end size",
    **{name: GROUPS[name] for name in ("stability", "column_motion", "drive", "slips", "bursts")},
}  # the same in three


class Packing(Table):
    """The group of a packing: its own Table, and a Table by name for each of its parts."""

    parts: "dict[str, Table]"  #: by name

    def __init__(self, group):
        super().__init__(group, "id neighbours connectivity connectivity_error")
        self.parts = {name: Table(part) for name, part in group.items() if isinstance(part, h5py.Group)}


class Analysis(dict):
    """The analysis of the last state of a run: a Table by name of its group, None for an absent group."""

    attributes: dict  #: of analysis.h5: repose_version, time [T] of the state
    packing: "Packing | None"  #: of what /packing holds; None without

    def __init__(self, path, dimension=2):
        needed = GROUPS if dimension == 2 else SPHERE_GROUPS
        with opened(path) as file:
            self.attributes = attributes_of(file)
            check_format(path, self.attributes, "analysis", FORMAT_VERSION, ["time"])
            groups = [*needed, *(name for name in file if name not in needed and name != "packing")]
            super().__init__({name: Table(file[name], needed.get(name, "")) if name in file else None for name in groups})
            self.packing = Packing(file["packing"]) if "packing" in file else None
