# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs a program and says what it cost."""

import os
import subprocess
import tempfile
from dataclasses import dataclass

INSTRUCTION_SET = "REPOSE_INSTRUCTION_SET"  # the environment variable by which methods choose theirs
ONE_THREAD = {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}


class Failed(Exception):
    """A program to be timed did not run."""


@dataclass(frozen=True)
class Done:
    output: str
    cpu_seconds: float
    peak_mib: float


def run(command, instructions=None, cwd=None, given=None):
    """Runs a command, by one instruction set if one is named; raises Failed with the end of its output if it fails.

    `given` is text for its standard input.
    """
    command = [str(word) for word in command]
    environment = os.environ | ONE_THREAD | ({INSTRUCTION_SET: instructions} if instructions else {})
    with tempfile.TemporaryFile("w+") as output, tempfile.TemporaryFile("w+") as text:
        text.write(given or "")
        text.seek(0)
        try:
            child = subprocess.Popen(
                command, stdin=text, stdout=output, stderr=subprocess.STDOUT, cwd=cwd, env=environment
            )
        except OSError as problem:
            raise Failed(f"{command[0]}: {problem.strerror}") from problem
        try:
            _, status, usage = os.wait4(child.pid, 0)
        except BaseException:
            child.kill()
            child.wait()
            raise
        child.returncode = os.waitstatus_to_exitcode(status)
        output.seek(0)
        said = output.read()
    if child.returncode != 0:
        raise Failed(f"{' '.join(command)}: exit status {child.returncode}\n{said[-2000:]}")
    return Done(said, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024)
