# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Tables as pandas data frames, and a run as a page of a notebook."""

import base64
import html

import numpy as np

AXES = "xyz"
SHOWN = ("angle_of_repose_deg.mean", "base_dip.index", "coordination", "heap_height", "max_overlap")


def to_pandas(columns):
    """A DataFrame of columns by name, each (N) or (N, D); those in D dimensions become name_x, name_y. ImportError without
    pandas."""
    import pandas

    flat = {}
    for name, column in columns.items():
        if np.ndim(column) == 2:
            flat |= {f"{name}_{AXES[k]}": column[:, k] for k in range(column.shape[1])}
        else:
            flat[name] = column
    return pandas.DataFrame(flat)


def sweep_to_pandas(sweep):
    """A DataFrame with a row per point of a SweepFolder: its parameters, and mean and standard error of every measure."""
    columns = {"point": sweep.points, "members": sweep.finished, **sweep.parameters}
    for name, table in sweep.measures.items():
        columns |= {name: table["mean"], f"{name}:error": table["error"]}
    return to_pandas(columns).set_index("point")


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
