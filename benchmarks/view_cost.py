#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""What an open view costs the run that it shows: CPU time of the run with a view, whose page takes every new frame, over
that without, in interleaved rounds.

usage: view_cost.py [--program REPOSE] [--rounds N]
"""

import argparse
import json
import os
import re
import signal
import socket
import statistics
import subprocess
import tempfile
import threading
import urllib.request
from pathlib import Path

SCENE = """[base]
kind = "row"
half_width = 60
[source]
kind = "pour"
count = 2000
rate = 20.0
height = 40
half_width = 20
[contact]
normal = { law = "hooke", stiffness = 5e3 }
tangential = { law = "linear", stiffness = 2.5e3 }
[stop]
time = 130
[output]
frames = 2
"""


def reader(address, read):
    """Does what an open page does: listens, and takes each new last state; counts the bytes."""
    port, path = re.fullmatch(r"http://127\.0\.0\.1:(\d+)(/.*/)", address).groups()
    with socket.create_connection(("127.0.0.1", int(port))) as events:
        events.sendall(f"GET {path}api/events HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\n\r\n".encode())
        while part := events.recv(65536):
            if b"event: change" in part:
                for name in ("api/run", "api/series", "api/frame/last"):
                    with urllib.request.urlopen(address + name) as answer:
                        read.append(len(answer.read()))


def seconds_of_run(program, folder, viewed):
    """CPU seconds of a run, those of its view, and the bytes that the page read."""
    folder.mkdir()
    (folder / "scene.toml").write_text(SCENE)
    run = subprocess.Popen([program, "run", "scene.toml", "--out", "out", "--quiet", "--threads", "1"], cwd=folder)
    read, view = [], None
    if viewed:
        while not (folder / "out/run.h5").exists():
            pass
        view = subprocess.Popen([program, "view", str(folder / "out"), "--no-browser"], stdout=subprocess.PIPE, text=True)
        threading.Thread(target=reader, args=(view.stdout.readline().strip(), read), daemon=True).start()
    _, status, used = os.wait4(run.pid, 0)
    assert status == 0
    cost = 0.0
    if view:
        view.send_signal(signal.SIGINT)
        _, _, spent = os.wait4(view.pid, 0)
        cost = spent.ru_utime + spent.ru_stime
    return used.ru_utime + used.ru_stime, cost, sum(read)


def main():
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--program", default="build/release/repose")
    options.add_argument("--rounds", type=int, default=5)
    chosen = options.parse_args()
    program = str(Path(chosen.program).resolve())
    ratios, costs, megabytes = [], [], 0.0
    with tempfile.TemporaryDirectory() as place:
        for k in range(chosen.rounds):
            alone, _, _ = seconds_of_run(program, Path(place) / f"alone-{k}", False)
            viewed, cost, size = seconds_of_run(program, Path(place) / f"viewed-{k}", True)
            ratios.append(viewed / alone)
            costs.append(cost / viewed)
            megabytes = size / 1e6
    spread = statistics.stdev(ratios) if len(ratios) > 1 else float("nan")
    print(json.dumps({"ratio_median": round(statistics.median(ratios), 4), "ratio_deviation": round(spread, 4),
                      "view_over_run": round(statistics.median(costs), 4), "read_MB": round(megabytes, 1), "rounds": chosen.rounds}))


if __name__ == "__main__":
    main()
