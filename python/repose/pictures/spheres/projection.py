# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Side view and top view of spheres: nearer ones cover those behind them and are darker."""

import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import ListedColormap, Normalize, to_rgb
from matplotlib.patches import Patch

from repose import style
from repose.pictures.run.legends import BAR_ROW, colour_bar_above
from repose.pictures.run.space_box import space_box
from repose.pictures.run.species import kinds_of, members_of
from repose.pictures.run.visible_box import wrapped
from repose.pictures.spheres.panels import edge_width, make_views
from repose.pictures.spheres.places import Plane, add_circles, images, upright_plane
from repose.pictures.spheres.wall_sections import add_wall_sections

NEAREST, FARTHEST = 1.0, 0.22  # strength of a colour
DEEPER = 2.0  # power of the colours of discs, which are light
CELLS = 12  # across a nominal diameter, of the grid that tells which spheres are in sight
MOST_CELLS = 2000  # along a side of it


def draw(run, state):
    """Figure of one state. Spheres out of sight are left out."""
    box = space_box(run, state)
    middle = 0.5 * (box.low[2] + box.high[2])
    side, top = upright_plane(box), Plane(0, 1, 2, middle)
    panels = make_views(run, state, [side, top], [BAR_ROW, BAR_ROW], remark="side view along y, top view")
    kinds = kinds_of(run)
    units = style.units_of(run)
    for panel, plane, towards in zip(panels, (side, top), (-1.0, 1.0)):
        add_wall_sections(panel, run, state, plane)
        ends = _depths(run, state, box, plane.axis)
        _add_spheres(panel, run, state, box, plane, towards, ends, kinds)
        ramp = _ramp(style.SPECIES[0] if len(kinds) == 1 else style.FAINT)
        colours = ListedColormap(ramp[:: int(towards)], "depth")
        handles = _legend(kinds) if plane is side and len(kinds) > 1 else ()
        title = units.length("yz"[plane.axis == 2])
        colour_bar_above(panel, ScalarMappable(Normalize(*ends), colours), title, handles)
    return panels[0].figure


def _depths(run, state, box, axis):
    """Ends [L] of the moving spheres in the box along an axis, which the colours span; those of all without any."""
    if state.axes:  # the same colours in all frames
        return box.low[axis], box.high[axis]
    centre = wrapped(run, state.grains.position)
    inside = box.holds(centre)
    some = inside & ~state.grains.held
    at = centre[some if some.any() else inside, axis]
    return (at.min(), at.max()) if np.ptp(at) > 0.0 else (box.low[axis], box.high[axis])


def _add_spheres(panel, run, state, box, plane, towards, ends, kinds):
    """The spheres in sight from the side of the plane where `towards` times the position along its axis is large; colours
    span the `ends` [L] along it."""
    grains = state.grains
    centre = wrapped(run, grains.position)
    shown = np.flatnonzero(np.isfinite(centre).all(axis=1))
    centre, copy = images(run, centre[shown], (plane.across, plane.up))
    row = shown[copy]
    low, high = box.low[plane.axis], box.high[plane.axis]
    seen = panel.box.near(plane.flat(centre), grains.radius[row])
    seen &= (centre[:, plane.axis] >= low) & (centre[:, plane.axis] <= high)
    centre, row = centre[seen], row[seen]
    front = towards * centre[:, plane.axis]
    order = np.lexsort((row, front))
    centre, row, front = centre[order], row[order], front[order]
    flat, radius = plane.flat(centre), grains.radius[row]
    visible = in_sight(flat, radius, panel.box, run.attributes["grain_diameter"])
    flat, radius, row = flat[visible], radius[visible], row[visible]
    nearness = (front[visible] - min(towards * ends[0], towards * ends[1])) / (ends[1] - ends[0])
    faces, edges = _colours_of(nearness, members_of(kinds, grains)[row], grains.held[row])
    add_circles(panel, flat, radius, facecolors=faces, edgecolors=edges, linewidths=edge_width(run, panel))


def in_sight(flat, radius, box, diameter):
    """Rows (K) of the discs, given from back to front, of which something is not covered by others: by the points of a grid
    with CELLS points across a nominal diameter."""
    cell = max(diameter / CELLS, (box.x_max - box.x_min) / MOST_CELLS, (box.y_max - box.y_min) / MOST_CELLS)
    x = np.arange(box.x_min, box.x_max + cell, cell)
    y = np.arange(box.y_min, box.y_max + cell, cell)
    owner = np.full((len(y), len(x)), -1)
    for k, ((at_x, at_y), reach) in enumerate(zip(flat, radius)):
        columns = slice(*np.searchsorted(x, (at_x - reach, at_x + reach)))
        rows = slice(*np.searchsorted(y, (at_y - reach, at_y + reach)))
        covered = (x[None, columns] - at_x) ** 2 + (y[rows, None] - at_y) ** 2 < reach**2
        owner[rows, columns][covered] = k
    visible = np.unique(owner)
    return visible[visible >= 0]


def _colours_of(nearness, member, held):
    """Face and edge colours (K, 3) of spheres of these kinds (K); held ones are grey."""
    base = np.array([_deep(style.SPECIES[k % len(style.SPECIES)]) for k in range(member.max(initial=0) + 1)])
    face = np.where(held[:, None], to_rgb(style.HELD), base[member])
    edge = np.where(held[:, None], to_rgb("#222222"), to_rgb(style.GRAIN_EDGE))
    strength = (FARTHEST + (NEAREST - FARTHEST) * np.clip(nearness, 0.0, 1.0))[:, None]
    return 1.0 - strength * (1.0 - face), 1.0 - strength * (1.0 - edge)


def _deep(colour):
    return np.array(to_rgb(colour)) ** DEEPER


def _ramp(colour):
    """Colours (256, 3) from the farthest to the nearest."""
    strength = np.linspace(FARTHEST, NEAREST, 256)[:, None]
    return 1.0 - strength * (1.0 - _deep(colour))


def _legend(kinds):
    return [
        Patch(facecolor=_deep(style.SPECIES[k % len(style.SPECIES)]), edgecolor=style.GRAIN_EDGE, linewidth=0.4, label=kind.name)
        for k, kind in enumerate(kinds)
    ]
