# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Tables as pandas data frames."""

import numpy as np

AXES = "xyz"


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
