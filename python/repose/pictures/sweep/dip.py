# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Dip index of the base profile over what a sweep varies: mean of the members, and of their mean profile."""

import numpy as np
from matplotlib.figure import Figure

from repose import style
from repose.not_drawn import NotDrawn
from repose.pictures.sweep.axis import add_legend, axis_of, draw_measure, label_axis, line_at, points_height
from repose.pictures.sweep.measured import draw_measured, has

KEY = "base_dip.index"
TOP = 0.26  # inch of the caption


def draw(sweep):
    """One figure; above the dashed line the force on the base is largest beside the middle."""
    index, error = of_profiles(sweep, "dip_index"), of_profiles(sweep, "dip_index_error")
    panels = [
        ("of each member", has(sweep, KEY)),
        ("of the mean profile", bool(np.isfinite(index).any())),
    ]
    panels = [name for name, there in panels if there]
    if not panels:
        raise NotDrawn("no member has a loaded base")
    axis = axis_of(sweep)
    figure = Figure(figsize=(1.2 + 2.7 * len(panels), points_height(axis, sweep, 2.8) + TOP))
    columns = figure.subplots(1, len(panels), sharex=True, sharey=True, squeeze=False)[0]
    for axes, name in zip(columns, panels):
        if name == "of each member":
            draw_measured(axes, axis, sweep, KEY)
        else:
            draw_measure(axes, axis, index, error)
        line_at(axes, axis, 1.0)
        label_axis(axes, axis, sweep, "dip index")
        axes.set_title(name, fontsize=8)
    for axes in columns[1:]:
        if axis.key is not None:
            axes.set_ylabel("")
    height = figure.get_size_inches()[1]
    top = TOP + add_legend(figure, columns[0], axis, TOP)
    figure.tight_layout(pad=0.4, w_pad=1.2, rect=(0.0, 0.0, 1.0, 1.0 - top / height))
    style.caption(figure, "± standard error between members; above 1: less force in the middle than beside it")
    return [figure]


def of_profiles(sweep, attribute):
    """An attribute of the mean profile by point (P); NaN without."""
    return np.array([np.nan if each is None else each.attributes[attribute] for each in sweep.profiles])
