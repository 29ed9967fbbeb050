# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""What a notebook shows of a run."""

import base64
import html

SHOWN = ("angle_of_repose_deg.mean", "base_dip.index", "coordination", "heap_height", "max_overlap")


def number_at(summary, dotted):
    """A number of a summary by its dotted name; None where there is none."""
    for step in dotted.split("."):
        if not isinstance(summary, dict) or step not in summary:
            return None
        summary = summary[step]
    return summary if isinstance(summary, (int, float)) else None


def run_html(run):
    """What a notebook shows of a RunFolder: its facts, a few measures, and the picture of the heap if it was drawn."""
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
    picture = run.path / "pictures/heap.png"
    shown = ""
    if picture.is_file():
        data = base64.b64encode(picture.read_bytes()).decode("ascii")
        shown = f'<img src="data:image/png;base64,{data}" alt="grains of the run" style="max-width: 40em">'
    return f"<b>{html.escape(run.attributes['title'])}</b><table>{rows}</table>{shown}"
