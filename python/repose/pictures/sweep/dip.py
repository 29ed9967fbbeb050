# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Dip index of the base profile over the axis of a sweep: mean over the members, and that of their mean profile."""

import numpy as np
from matplotlib.figure import Figure

from repose import style
from repose.errors import NotDrawn
from repose.pictures.sweep.axis import axis_of
from repose.pictures.sweep.panel import (
    TOP,
    add_legend,
    caption,
    draw_means,
    draw_measure,
    has_measure,
    label_axes,
    mark_value,
    panel_height,
)

KEY = "base_dip.index"


def draw(sweep):
    """One figure; the dashed line is at 1, above which the force on the base dips in the middle."""
    index, error = of_profiles(sweep, "dip_index"), of_profiles(sweep, "dip_index_error")
    panels = [
        ("mean over the members", has_measure(sweep, KEY)),
        ("of the mean profile", bool(np.isfinite(index).any())),
    ]
    panels = [name for name, exists in panels if exists]
    if not panels:
        raise NotDrawn("no member has a loaded base")
    axis = axis_of(sweep)
    figure = Figure(figsize=(1.2 + 2.7 * len(panels), panel_height(axis, sweep, 2.8) + TOP))
    columns = figure.subplots(1, len(panels), sharex=True, sharey=True, squeeze=False)[0]
    for axes, name in zip(columns, panels):
        if name == "mean over the members":
            draw_measure(axes, axis, sweep, KEY)
        else:
            draw_means(axes, axis, index, error)
        mark_value(axes, axis, 1.0)
        label_axes(axes, axis, sweep, "dip index")
        axes.set_title(name, fontsize=8)
    for axes in columns[1:]:
        if axis.key is not None:
            axes.set_ylabel("")
    height = figure.get_size_inches()[1]
    top = TOP + add_legend(figure, columns[0], axis, TOP)
    style.fit(figure, (0.0, 0.0, 1.0, 1.0 - top / height), w_pad=1.2)
    caption(figure, axis, sweep, "± standard error over the members; above 1 the force is smaller in the middle than beside it")
    return [figure]


def of_profiles(sweep, attribute):
    """An attribute of the mean profile of each point (P); NaN where there is none."""
    return np.array([np.nan if each is None else each.attributes[attribute] for each in sweep.profiles])
