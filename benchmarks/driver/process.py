# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs a program and says what it cost."""

import os
import re
import subprocess
import tempfile
import time
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


def _wait(pid):
    """(status, resource usage, largest memory [KiB]) of a child that ends.

    The largest memory in the resource usage would include that of this program, from which the child was forked.
    """
    peak = 0
    while True:
        try:
            with open(f"/proc/{pid}/status", encoding="utf-8") as file:
                found = re.search(r"^VmHWM:\s*(\d+)", file.read(), re.M)
            peak = max(peak, int(found.group(1)) if found else 0)
        except OSError:
            pass  # no such file here
        ended, status, usage = os.wait4(pid, os.WNOHANG)
        if ended:
            return status, usage, peak
        time.sleep(0.02)


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
            status, usage, peak_kib = _wait(child.pid)
        except BaseException:
            child.kill()
            child.wait()
            raise
        child.returncode = os.waitstatus_to_exitcode(status)
        output.seek(0)
        said = output.read()
    if child.returncode != 0:
        raise Failed(f"{' '.join(command)}: exit status {child.returncode}\n{said[-2000:]}")
    return Done(said, usage.ru_utime + usage.ru_stime, peak_kib / 1024)
