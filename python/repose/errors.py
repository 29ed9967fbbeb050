# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Errors that the readers and the pictures raise."""


class RunFolderError(ValueError):
    """A run or sweep folder cannot be read; the message is one line."""


class NotDrawn(Exception):
    """A picture has nothing to show; the message says what is missing."""


def one_line(error):
    """Message of an exception without line breaks and outer quotes."""
    return " ".join(str(error).strip("'\"").split())
