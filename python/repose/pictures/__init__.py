# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of runs (`run`), of sweeps (`sweep`) and of stress models (`models`)."""
