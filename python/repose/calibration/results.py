# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Results of a calibration: calibration.json, posterior.csv and points.csv, and the table that is printed."""

import csv
import io
import json
import math
from pathlib import Path

import numpy as np

from repose.calibration.posterior import LEVEL, warnings_of
from repose.calibration.sweep_rounds import point_name, write_text

FORMAT_VERSION = 1
DRAWS = 4000  # rows of posterior.csv
STOPPED = {
    "certain": "the surrogates are certain enough over the posterior",
    "most": "the largest number of points is reached before the surrogates are certain enough",
}


def write_results(folder, plan, measured, fit, stopped):
    """Writes the files; returns the content of calibration.json."""
    content = content_of(plan, measured, fit, stopped)
    write_text(Path(folder, "posterior.csv"), posterior_csv(plan, fit))
    write_text(Path(folder, "points.csv"), points_csv(plan, measured, fit))
    write_text(Path(folder, "calibration.json"), json.dumps(_plain(content), indent=1, ensure_ascii=False) + "\n")
    return content


def _plain(value):
    """Values as JSON has them: numbers of Python, null for what is not finite."""
    if isinstance(value, dict):
        return {key: _plain(entry) for key, entry in value.items()}
    if isinstance(value, (list, tuple, np.ndarray)):
        return [_plain(entry) for entry in value]
    if isinstance(value, np.integer):
        return int(value)
    if isinstance(value, (float, np.floating)):
        return float(value) if math.isfinite(value) else None
    return value


def content_of(plan, measured, fit, stopped):
    """All results as a dictionary; docs/reference/calibration.md describes it."""
    posterior = fit.posterior
    rounds = np.bincount(measured.round)[1:]
    return {
        "format": "repose-calibration",
        "format_version": FORMAT_VERSION,
        "title": plan.title,
        "file": plan.text,
        "rounds": [{"round": k + 1, "points": count} for k, count in enumerate(rounds)],
        "members_failed": measured.failed.sum(),
        "points": [_point(plan, measured, fit, row) for row in range(len(measured.values))],
        "surrogates": [_surrogate(plan, fit, k) for k in range(len(plan.targets))],
        "posterior": {
            "draws": len(posterior.weight),
            "effective_draws": posterior.effective,
            "parameters": _parameters(plan, posterior),
            "correlation": posterior.moments()[2],
        },
        "targets": _targets(plan, fit),
        "best_chi_square": posterior.chi_square.min(),
        "stopped": stopped,
        "warnings": left_out(plan, measured, fit) + warnings_of(plan, posterior),
    }


def _point(plan, measured, fit, row):
    targets = {}
    for k, target in enumerate(plan.targets):
        mean, error, count = _of_point(fit.means[k], row)
        targets[target.measure] = {"mean": mean, "error": error, "members": count}
    return {
        "name": point_name(row + 1),
        "round": measured.round[row],
        "parameters": dict(zip([p.key for p in plan.parameters], measured.values[row])),
        "failed": measured.failed[row],
        "targets": targets,
    }


def _of_point(means, row):
    """Mean, error and number of members of a point; NaN where it is left out."""
    at = np.flatnonzero(means.rows == row)
    mean, error = (means.mean[at[0]], means.error[at[0]]) if len(at) else (math.nan, math.nan)
    return mean, error, means.count[row]


def _surrogate(plan, fit, k):
    surrogate, means = fit.surrogates[k], fit.means[k]
    return {
        "measure": plan.targets[k].measure,
        "points": len(means.rows),
        "deviation_between_seeds": means.deviation,
        "mean": surrogate.centre,
        "amplitude": surrogate.amplitude,
        "lengths": dict(zip([p.key for p in plan.parameters], surrogate.lengths)),
    }


def _parameters(plan, posterior):
    mean, deviation, _ = posterior.moments()
    tail = 0.5 * (1.0 - LEVEL)
    quantiles = posterior.quantiles([tail, 0.5, 1.0 - tail])
    return [
        {
            "key": p.key,
            "range": [p.low, p.high],
            "prior": {"mean": p.mean, "deviation": p.deviation} if p.prior == "normal" else p.prior,
            "mean": mean[k],
            "deviation": deviation[k],
            "median": quantiles[k, 1],
            "low": quantiles[k, 0],
            "high": quantiles[k, 2],
        }
        for k, p in enumerate(plan.parameters)
    ]


def _targets(plan, fit):
    predicted, deviation = fit.posterior.predicted()
    uncertain = fit.posterior.surrogate_deviation()
    return [
        {
            "measure": target.measure,
            "value": target.value,
            "error": target.error,
            "predicted": predicted[k],
            "predicted_deviation": deviation[k],
            "surrogate_deviation": uncertain[k],
        }
        for k, target in enumerate(plan.targets)
    ]


def left_out(plan, measured, fit):
    """Lines about members and points that the fits are without."""
    lines = []
    if measured.failed.any():
        lines.append(f"{measured.failed.sum()} members failed and are left out")
    for target, means in zip(plan.targets, fit.means):
        missing = len(measured.values) * plan.seeds - means.count.sum() - measured.failed.sum()
        if missing:
            lines.append(f"{target.measure}: {missing} members have no value and are left out")
        if len(means.rows) < len(measured.values):
            names = [point_name(row + 1) for row in np.flatnonzero(means.count < 2)]
            lines.append(f"{target.measure}: points with fewer than two values are left out: {', '.join(names)}")
    return lines


def _csv(rows):
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows(rows)
    return text.getvalue()


def _number(value):
    """A number with all its digits; "" where there is none."""
    return "" if math.isnan(value) else repr(float(value))


def posterior_csv(plan, fit):
    """Draws with equal weights: the parameters, and the surrogates' mean of each target."""
    posterior = fit.posterior
    rows = posterior.resampled(DRAWS, plan.design.seed)
    table = np.column_stack([posterior.values[rows], posterior.mean[:, rows].T])
    head = [p.key for p in plan.parameters] + [target.measure for target in plan.targets]
    return _csv([head, *(map(_number, row) for row in table)])


def points_csv(plan, measured, fit):
    """A row for each point: parameters, members that failed; per target mean, standard error and members."""
    head = ["point", "round", *(p.key for p in plan.parameters), "failed"]
    for target in plan.targets:
        head += [target.measure, f"{target.measure}:error", f"{target.measure}:count"]
    rows = [head]
    for row, values in enumerate(measured.values):
        cells = [point_name(row + 1), measured.round[row], *map(_number, values), measured.failed[row]]
        for means in fit.means:
            mean, error, count = _of_point(means, row)
            cells += [_number(mean), _number(error), count]
        rows.append(cells)
    return _csv(rows)


def summary_text(content):
    """The tables that end a calibration."""
    parameters, targets = content["posterior"]["parameters"], content["targets"]
    width = max(len(name) for name in ["parameter", *(p["key"] for p in parameters), *(t["measure"] for t in targets)])
    lines = [f"{'parameter':{width}}  {'median':>10}  90 % interval"]
    lines += [f"{p['key']:{width}}  {p['median']:10.4g}  {p['low']:.4g} to {p['high']:.4g}" for p in parameters]
    lines += ["", f"{'target':{width}}  {'wanted':>18}  {'predicted':>18}"]
    for t in targets:
        wanted = f"{t['value']:.4g} +- {t['error']:.2g}"
        predicted = f"{t['predicted']:.4g} +- {t['predicted_deviation']:.2g}"
        lines.append(f"{t['measure']:{width}}  {wanted:>18}  {predicted:>18}")
    members = f"{len(content['points'])} points, {content['posterior']['effective_draws']:.0f} effective draws"
    lines += ["", f"{members}: {STOPPED[content['stopped']]}"]
    lines += [f"warning: {line}" for line in content["warnings"]]
    return "\n".join(lines)
