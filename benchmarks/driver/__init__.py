# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The benchmarks that ./dev bench runs: one file for each method, peer, or part of the machinery."""
