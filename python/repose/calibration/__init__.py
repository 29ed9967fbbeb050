# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Calibration: parameters of a scene from measured targets. docs/reference/calibration.md describes method and files.

A plan (plan.py, read by file_reader.py) has parameters with priors and targets with errors. The loop (loop.py) measures
rounds of points (design.py; by sweeps in sweep_rounds.py), fits a surrogate to each target (scatter.py, surrogate.py)
and weights draws of the prior (posterior.py). results.py and picture.py write what it finds.
"""
