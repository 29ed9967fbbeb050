#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Builds from an empty folder, build/cost, and prints the CPU seconds (user and system) that it takes, target by target.
Never through ccache. Other work on the machine makes the numbers larger.

usage: build_cost.py [--preset NAME] [--target NAME] [--files N] [--limit SECONDS]
"""

import argparse
import collections
import json
import os
import re
import resource
import shutil
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
FOLDER = ROOT / "build/cost"
LOG = FOLDER / "cpu_seconds.txt"
OBJECT = re.compile(r"(?:^|/)CMakeFiles/([^/]+)\.dir/(.*)")


def cpu_seconds_of_children():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def run_and_note(command):
    """What CMake calls in place of the compiler and the linker: runs the command and notes its CPU seconds."""
    status = subprocess.run(command).returncode
    output = command[command.index("-o") + 1] if "-o" in command else command[-1]
    with LOG.open("a") as log:  # one short line, which the system appends as a whole
        log.write(json.dumps([output, cpu_seconds_of_children()]) + "\n")
    return status


def target_of(output):
    """The target that an object, library or program belongs to."""
    found = OBJECT.search(output)
    return found[1] if found else "links"


def build(preset, target):
    """Configures and builds; returns CPU and wall seconds of the build."""
    shutil.rmtree(FOLDER, ignore_errors=True)
    launcher = f"{sys.executable};{Path(__file__).resolve()};--note"
    settings = [f"-DCMAKE_CXX_{tool}_LAUNCHER={launcher}" for tool in ("COMPILER", "LINKER")]
    environment = {**os.environ, "CCACHE_DISABLE": "1"}
    subprocess.run(["cmake", "--preset", preset, "-B", FOLDER, *settings], cwd=ROOT, env=environment, check=True,
                   stdout=subprocess.DEVNULL)
    LOG.unlink(missing_ok=True)
    before, began = cpu_seconds_of_children(), time.monotonic()
    command = ["cmake", "--build", FOLDER, "--parallel", str(os.cpu_count())]
    subprocess.run(command + (["--target", target] if target else []), env=environment, check=True)
    return cpu_seconds_of_children() - before, time.monotonic() - began


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--preset", default="release", help="of CMakePresets.json (default: release)")
    parser.add_argument("--target", help="build this target alone, with what it needs (default: all)")
    parser.add_argument("--files", type=int, default=10, help="how many of the dearest files to list (default: 10)")
    parser.add_argument("--limit", type=float, help="exit status 1 if the build takes more CPU seconds")
    options = parser.parse_args()
    cpu, wall = build(options.preset, options.target)

    entries = [json.loads(line) for line in LOG.read_text().splitlines()]
    targets = collections.defaultdict(list)
    for output, seconds in entries:
        targets[target_of(output)].append(seconds)
    print("\nCPU seconds  commands  target")
    for name, seconds in sorted(targets.items(), key=lambda item: -sum(item[1])):
        print(f"{sum(seconds):11.1f}  {len(seconds):8}  {name}")
    print("\nCPU seconds  file")
    for output, seconds in sorted(entries, key=lambda entry: -entry[1])[: options.files]:
        print(f"{seconds:11.1f}  {output}")
    what = f"target {options.target}" if options.target else "everything"
    print(f"\nCPU seconds of {what}, preset {options.preset}: {cpu:.0f} ({wall:.0f} s on {os.cpu_count()} cores)")
    return 1 if options.limit and cpu > options.limit else 0


if __name__ == "__main__":
    sys.exit(run_and_note(sys.argv[2:]) if sys.argv[1:2] == ["--note"] else main())
