# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Force network in an upright section of a heap of spheres: the contacts within half a diameter of the plane, as lines between
the centres of their partners."""

import numpy as np

from repose import style
from repose.pictures.run.forces import add_force_lines, largest_of
from repose.pictures.run.legends import LEGEND_ROW
from repose.pictures.run.shapes import centre_lines
from repose.pictures.run.space_box import space_box
from repose.pictures.spheres.panels import make_views
from repose.pictures.spheres.places import add_circles, circles_in, upright_plane
from repose.pictures.spheres.section import where
from repose.pictures.spheres.wall_sections import add_wall_sections


def draw(run, state):
    """Figure of one state; forces in grain weights, or in the units of the scene where there is no gravity."""
    largest = largest_of(run, state)
    plane = upright_plane(space_box(run, state))
    half = style.units_of(run).length_value(0.5 * run.attributes["grain_diameter"])
    remark = f"{where(run, plane)}, contacts within {half} of it"
    (panel,) = make_views(run, state, [plane], [LEGEND_ROW], remark=remark)
    add_section_of_forces(panel, run, state, plane, largest)
    return panel.figure


def add_section_of_forces(panel, run, state, plane, largest):
    """Walls and spheres that the plane cuts, and forces in the contacts near it, with their legend above the axes."""
    add_wall_sections(panel, run, state, plane)
    centre, radius, row = circles_in(run, state, plane, panel.box)
    held = state.grains.held[row]
    faint = dict(facecolors="#eff1f4", edgecolors="#d3d8df", linewidths=0.25)
    add_circles(panel, centre[~held], radius[~held], **faint)
    add_circles(panel, centre[held], radius[held], facecolors=style.FAINT, edgecolors="white", linewidths=0.25)
    lines, contact = lines_near(run, state, plane)
    add_force_lines(panel, run, state, plane.flat(lines), contact, largest)


def lines_near(run, state, plane):
    """Lines (K, 2, 3) [L] between the partners of the contacts within half a nominal diameter of the plane, and the rows of
    these contacts (K)."""
    lines, contact = centre_lines(run, state)
    first = state.rows(state.contacts.grains[contact, 0])
    place = lines[:, 0] - state.contacts.normal[contact] * state.grains.radius[first, None]
    near = np.abs(plane.distance(run, place)) <= 0.5 * run.attributes["grain_diameter"]
    return lines[near], contact[near]
