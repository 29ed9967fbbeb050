# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""What a notebook shows of a run."""

import base64
import html

MOST_GRAINS = 50000  # of all frames together: pages of one or two megabytes

SHOWN = ("angle_of_repose_deg.mean", "base_dip.index", "coordination", "heap_height", "max_overlap")


def number_at(summary, dotted):
    """A number of a summary by its dotted name; None where there is none."""
    for step in dotted.split("."):
        if not isinstance(summary, dict) or step not in summary:
            return None
        summary = summary[step]
    return summary if isinstance(summary, (int, float)) else None


def run_html(run):
    """What a notebook shows of a RunFolder: its facts, a few measures, and the page of `repose view`, or for a large run the
    picture of the heap if it was drawn."""
    numbers = {name: number_at(run.summary, name) for name in SHOWN}
    facts = {
        "folder": str(run.path),
        "status": run.attributes["status"],
        "time": f"{run.attributes['time']:.6g}",
        "grains": len(run.state.grains),
        "contacts": len(run.state.contacts),
        **{name: f"{value:.6g}" for name, value in numbers.items() if value is not None},
    }
    rows = "".join(f"<tr><th>{html.escape(name)}</th><td>{html.escape(str(fact))}</td></tr>" for name, fact in facts.items())
    return f"<b>{html.escape(run.attributes['title'])}</b><table>{rows}</table>{page_of(run) or picture_of(run)}"


def page_of(run):
    """The page of `repose view` with the run in it: all frames of a small run, else the last state; "" for a large one or
    where the page cannot be made, as for spheres."""
    grains = len(run.state.grains)
    if grains > MOST_GRAINS or run.attributes["dimension"] != 2:
        return ""
    try:
        from repose_compiled import exported_page
    except ImportError:  # without the compiled module
        return ""
    try:
        page = exported_page(str(run.path), grains * (len(run.frames) + 1) <= MOST_GRAINS)
    except ValueError:  # a file of the folder is damaged or being replaced
        return ""
    return (f'<iframe srcdoc="{html.escape(page)}" sandbox="allow-scripts" title="the run" '
            'style="width: 100%; height: 36em; border: 1px solid #8886"></iframe>')


def picture_of(run):
    """The picture of the heap, if it was drawn."""
    picture = run.path / "pictures" / ("heap.png" if run.attributes["dimension"] == 2 else "projection.png")
    if not picture.is_file():
        return ""
    data = base64.b64encode(picture.read_bytes()).decode("ascii")
    return f'<img src="data:image/png;base64,{data}" alt="grains of the run" style="max-width: 40em">'
