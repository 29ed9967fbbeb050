# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""A column of spheres in an upright cylinder: its force network in a section, and beside it the stresses by height with
Janssen's law."""

from dataclasses import replace

import numpy as np

from repose.pictures.janssen import Janssen
from repose.pictures.run.analysis_parts import analysis_table
from repose.pictures.run.column import BESIDE, draw_beside, legend_rows
from repose.pictures.run.forces import largest_of
from repose.pictures.run.legends import LEGEND_ROW
from repose.pictures.run.space_box import space_box
from repose.pictures.spheres.forces import add_section_of_forces
from repose.pictures.spheres.panels import make_views
from repose.pictures.spheres.places import upright_plane
from repose.pictures.spheres.section import where

NO_COLUMN = "no column in an upright cylinder was measured"


def draw(run, state):
    """Figure of the last state, and of means over output.window."""
    column = analysis_table(run, state, "column", NO_COLUMN)
    largest = largest_of(run, state)
    plane = replace(upright_plane(space_box(run, state)), level=column.attributes.get("axis_y", 0.0))
    rows = [legend_rows(run) * LEGEND_ROW]
    (panel,) = make_views(run, state, [plane], rows, beside=BESIDE, remark=where(run, plane))
    add_section_of_forces(panel, run, state, plane, largest)
    draw_beside(panel, run, column, law_of_cylinder(run, column.attributes), column.attributes.get("floor", 0.0))
    return panel.figure


def law_of_cylinder(run, values):
    """Janssen's law of the measured stress ratio and friction: no fit to the stresses drawn."""
    gravity = np.linalg.norm(np.asarray(run.attributes.get("gravity", [0.0, 0.0, np.nan]), dtype=float))
    weight = values.get("mass", np.nan) * gravity
    names = ("radius", "height", "stress_ratio", "friction")
    return Janssen.in_cylinder(**{name: values.get(name, np.nan) for name in names}, weight=weight)
