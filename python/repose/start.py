# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs a module of the package for the program: `python3 start.py MODULE PACKAGE ARGUMENTS`.

Any failure is one line and an exit status. The file is run by its path, so that it can report a package that is missing.
"""

import signal
import sys

INTERRUPTED = 130
interrupts = []


def interrupt(*_):
    """Remembers Ctrl-C: imports turn the KeyboardInterrupt into errors of their own."""
    interrupts.append(True)
    raise KeyboardInterrupt


def silenced():
    """Drops what standard output still holds: its reader has left."""
    import os

    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def complain(text):
    """Prints a line to standard error, if that takes it."""
    try:
        print(text, file=sys.stderr, flush=True)
    except OSError:
        sys.stderr = None


def one_line(error):
    """Message of an exception without line breaks."""
    return " ".join(str(error).split()) or type(error).__name__


def reason(error):
    """What a user reads of a failure."""
    if isinstance(error, ImportError):
        return f"repose: drawing needs the Python package {error.name}: {one_line(error)}"
    if isinstance(error, MemoryError):
        return "repose: not enough memory to draw this"
    return f"repose: cannot draw: {one_line(error)}"


def status_of(module):
    """Exit status of a module that runs as the main one."""
    import runpy

    try:
        runpy.run_module(module, run_name="__main__", alter_sys=True)
    except SystemExit as end:
        return end.code or 0
    except KeyboardInterrupt:
        return INTERRUPTED
    except BrokenPipeError:
        silenced()
    except Exception as error:  # a user gets one line, whatever it is
        if interrupts:
            return INTERRUPTED
        complain(reason(error))
        return 1
    return 0


def flushed(status):
    """The exit status after standard output has taken all that was printed."""
    try:
        if sys.stdout is not None:
            sys.stdout.flush()
    except BrokenPipeError:
        silenced()
    except OSError as error:
        complain(f"repose: standard output: cannot be written: {error.strerror}")
        silenced()
        return status or 1
    return status


def main():
    """Exit status of the module that the command line names."""
    module, package = sys.argv[1:3]
    del sys.argv[1:3]
    folder = __file__.rpartition("/")[0]
    sys.path[:] = [package, *(path for path in sys.path if path not in (folder, package))]
    return flushed(status_of(module))


if __name__ == "__main__":
    if signal.getsignal(signal.SIGINT) is not signal.SIG_IGN:
        signal.signal(signal.SIGINT, interrupt)
    try:
        STATUS = main()
    except KeyboardInterrupt:
        STATUS = INTERRUPTED
    sys.exit(STATUS)
