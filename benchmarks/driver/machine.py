# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""What the machine is and has."""

import os
import re

# What a processor must have for each instruction set, from the slowest to the fastest. "scalar" is the reference: the
# same results, one pair or contact at a time.
NEEDS = {
    "scalar": set(),
    "baseline": set(),
    "avx2": {"avx2"},
    "avx512": {"avx512f", "avx512dq", "avx512vl"},
}


def _cpuinfo(name):
    try:
        with open("/proc/cpuinfo", encoding="utf-8") as file:
            found = re.search(rf"^{name}\s*: (.*)$", file.read(), re.M)
    except OSError:
        found = None
    return found.group(1) if found else ""


def instruction_sets():
    """The instruction sets that the processor has; the last is the best."""
    has = set(_cpuinfo("flags").split())
    return [name for name, needs in NEEDS.items() if needs <= has]


def threads():
    return len(os.sched_getaffinity(0))


def describe():
    return {
        "processor": _cpuinfo("model name"),
        "threads": threads(),
        "instruction_sets": instruction_sets(),
        "load": round(os.getloadavg()[0], 1),
    }
