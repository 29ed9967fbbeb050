# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Errors that the readers and the pictures raise."""

import os
import sys


class RunFolderError(ValueError):
    """A run or sweep folder cannot be read; the message is one line."""


class NotDrawn(Exception):
    """A picture has nothing to show; the message says what is missing."""


def one_line(error):
    """Message of an exception without line breaks and outer quotes."""
    return " ".join(str(error).strip("'\"").split())


def say(text):
    """Prints a line to standard output. A reader that has left is no failure; SystemExit(1) if it cannot be written."""
    try:
        print(text)
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    except OSError as error:
        complain(f"repose: standard output: cannot be written: {error.strerror}")
        sys.stdout = None
        raise SystemExit(1) from error


def complain(text):
    """Prints a line to standard error. What cannot be written is lost: the exit status stays what it is."""
    try:
        if sys.stderr is not None:
            print(text, file=sys.stderr, flush=True)
    except OSError:
        sys.stderr = None
