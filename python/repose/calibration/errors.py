# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Reasons why a calibration ends without a result."""


class CalibrationError(ValueError):
    """A calibration cannot be read or written: `problems`, one line each."""

    def __init__(self, problems):
        super().__init__("\n".join(problems))
        self.problems = problems


class NotCalibrated(Exception):
    """The measurements allow no calibration; the message is one line."""


class SweepStopped(Exception):
    """A sweep has ended with this exit status; its messages have been printed."""

    def __init__(self, status):
        super().__init__(f"exit status {status}")
        self.status = status
