# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Upright section of a heap of spheres: each as the circle in which the plane cuts it, coloured by the force that it carries."""

import numpy as np
from matplotlib import colormaps
from matplotlib.colors import ListedColormap, Normalize

from repose import style
from repose.pictures.run.common_axes import largest_force
from repose.pictures.run.legends import BAR_ROW, colour_bar_above
from repose.pictures.run.space_box import space_box
from repose.pictures.spheres.panels import edge_width, make_views
from repose.pictures.spheres.places import add_circles, circles_in, upright_plane
from repose.pictures.spheres.wall_sections import add_wall_sections


def draw(run, state):
    """Figure of one state; the force on a sphere is the sum of its normal forces. Heights take the place of forces where
    there are none."""
    plane = upright_plane(space_box(run, state))
    (panel,) = make_views(run, state, [plane], [BAR_ROW], remark=where(run, plane))
    add_wall_sections(panel, run, state, plane)
    centre, radius, row = circles_in(run, state, plane, panel.box)
    held = state.grains.held[row]
    edge = edge_width(run, panel)
    add_circles(panel, centre[held], radius[held], facecolors=style.HELD, edgecolors="white", linewidths=0.5 * edge)
    values, title, largest = _shown(run, state)
    drawing = dict(edgecolors=style.GRAIN_EDGE, linewidths=edge, cmap=_colours(), norm=Normalize(0.0, largest))
    circles = add_circles(panel, centre[~held], radius[~held], array=values[row[~held]], **drawing)
    above = (values[row[~held]] > largest).any()
    colour_bar_above(panel, circles, title, extend="max" if above else "neither")
    return panel.figure


def where(run, plane):
    """Words that say which section a picture shows."""
    return f"section at y = {style.units_of(run).length_value(plane.level)}"


def carried(state):
    """Sum of the normal forces [M L/T^2] of the contacts of each grain (N)."""
    contacts = state.contacts
    size = np.abs(np.nan_to_num(contacts.normal_force))
    total = np.zeros(len(state.grains))
    for partner in contacts.grains.T:
        inside = partner >= 0
        np.add.at(total, state.rows(partner[inside]), size[inside])
    return total


def _shown(run, state):
    """Values of the colours (N), their title, and the value of the darkest."""
    units = style.units_of(run)
    force = carried(state)
    if (force > 0.0).any():
        unit = run.attributes["grain_weight"] or 1.0
        some = force[(force > 0.0) & ~state.grains.held] / unit
        word = units.force_word()
        title = "sum of normal forces on a grain" + (f" ({word})" if word else "")
        return force / unit, title, largest_force(some) or 1.0
    height = state.grains.position[:, 2]
    shown = height[~state.grains.held & np.isfinite(height)]
    return height, units.length("z"), max(shown.max(initial=0.0), run.attributes["grain_diameter"])


def _colours():
    """From nearly white to dark blue."""
    return ListedColormap(colormaps["Blues"](np.linspace(0.04, 0.95, 256)), "carried")
