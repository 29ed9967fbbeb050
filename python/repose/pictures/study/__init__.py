# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Figures of studies: panels, each by a function of axes, a StudyFolder and the table of the panel; or a standard picture of
a run or a sweep."""

from matplotlib.figure import Figure

from repose import style
from repose.errors import NotDrawn
from repose.pictures import pictures_of_run
from repose.pictures.study import base, claims, grains, measure, model, polar, rings
from repose.pictures.sweep import SWEEP_PICTURES

PANELS = {
    "grains": grains.draw_grains,
    "network": grains.draw_network,
    "forces": grains.draw_forces,
    "lines": grains.draw_lines,
    "base": base.draw,
    "rings": rings.draw,
    "measure": measure.draw,
    "bars": measure.draw_bars,
    "polar": polar.draw,
    "model": model.draw,
    "claims": claims.draw,
}
WIDTH, HEIGHT = 3.4, 2.6  # inch of a panel
HEIGHTS = {"grains": 1.9, "network": 1.9, "forces": 1.9, "lines": 1.9}  # of other kinds
CAPTION = 0.22  # inch


def draw_figure(study):
    """The figure of a study."""
    if "picture" in study.figure:
        return _picture(study)
    panels = study.figure.get("panel") or [{"kind": "claims"}]
    for panel in panels:
        if panel.get("kind") not in PANELS:
            raise NotDrawn(f"no panel \"{panel.get('kind')}\"; there are {', '.join(PANELS)}")
    columns = min(study.figure.get("columns", 2), len(panels))
    rows = -(-len(panels) // columns)
    height = max(HEIGHTS.get(panel["kind"], HEIGHT) for panel in panels)
    size = study.figure.get("size", [WIDTH * max(columns, 1.4), height * rows + CAPTION])
    figure = Figure(figsize=size)
    for k, panel in enumerate(panels):
        polar_axes = {"projection": "polar"} if panel["kind"] == "polar" else {}
        axes = figure.add_subplot(rows, columns, k + 1, **polar_axes)
        PANELS[panel["kind"]](axes, study, panel)
        if "title" in panel:
            axes.set_title(panel["title"], fontsize=8, loc="left", pad=4)
    style.fit(figure, (0.0, 0.0, 1.0, 1.0 - CAPTION / size[1]), h_pad=1.0, w_pad=1.0)
    style.caption(figure, _caption(study))
    return figure


def _caption(study):
    text = study.source
    if study.ensemble:
        count = len(study.ensemble["seeds"])
        text += f"; {count} {'run' if count == 1 else 'runs'} a point"
    return text


def _picture(study):
    """A standard picture, of a run where a point is named."""
    name, point = study.figure["picture"], study.figure.get("point")
    run = study.run(point, study.figure.get("seed")) if point else None
    known = pictures_of_run(run) if run else SWEEP_PICTURES
    if name not in known:
        raise NotDrawn(f"no picture \"{name}\"; there are {', '.join(known)}")
    if run:
        return known[name](run, run.state)
    figures = known[name](study.sweep)
    return figures[min(study.figure.get("part", 0), len(figures) - 1)]
