# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Drawing in careless surroundings: modules in the present folder, missing packages, settings of Matplotlib, Ctrl-C."""

import shutil
import signal
import subprocess
import time

import pytest
from conftest import LIMIT, PROGRAM, assert_plain


def plot(lab, heap, line="", **environment):
    if not (lab.path / "heap").exists():
        shutil.copytree(heap, lab.path / "heap")
    return lab.shell(f"$REPOSE plot heap --only heap,chains --format png {line}", **environment)


def test_nothing_is_imported_from_the_present_folder(lab, heap):
    for name in ("numbers", "random", "runpy", "types", "h5py", "numpy", "sitecustomize", "repose/__init__"):
        path = lab.path / f"{name}.py"
        path.parent.mkdir(exist_ok=True)
        path.write_text(f"open({str(lab.path / 'imported')!r}, 'a').write({name!r})\n")
    assert plot(lab, heap, PYTHONPATH=":/nowhere").returncode == 0
    assert lab.shell("$REPOSE theory pile-continuum --plot pile.png").returncode == 0
    assert not (lab.path / "imported").exists()


def test_settings_of_matplotlib_change_no_picture(lab, heap):
    assert plot(lab, heap).returncode == 0
    right = (lab.path / "heap/pictures/heap.png").read_bytes()
    (lab.path / "matplotlibrc").write_text("text.usetex: True\nfigure.facecolor: red\n")
    result = plot(lab, heap, MPLBACKEND="nonsense")
    assert result.returncode == 0, result.stderr
    assert (lab.path / "heap/pictures/heap.png").read_bytes() == right


@pytest.mark.parametrize("package", ["h5py", "matplotlib", "numpy"])
def test_a_missing_package_is_one_line(lab, heap, package):
    (lab.path / "broken").mkdir()
    (lab.path / f"broken/{package}.py").write_text(f"raise ImportError('No module named {package}', name={package!r})\n")
    result = plot(lab, heap, PYTHONPATH=str(lab.path / "broken"))
    assert result.returncode == 1
    assert result.stderr == f"repose: drawing needs the Python package {package}: No module named {package}\n"


def test_output_of_plot_that_nobody_reads(lab, heap):
    result = plot(lab, heap, "| true; exit ${PIPESTATUS[0]}")
    assert (result.returncode, result.stderr) == (0, "")
    result = plot(lab, heap, ">/dev/full")
    assert result.returncode == 1 and len(result.stderr.splitlines()) == 1, result.stderr


def test_plot_is_interrupted_quietly(lab, heap):
    shutil.copytree(heap, lab.path / "heap")
    began = time.monotonic()
    assert lab("plot", "heap").returncode == 0
    whole = time.monotonic() - began
    codes = []
    for part in (0.01, 0.2, 0.6):
        process = subprocess.Popen([PROGRAM, "plot", "heap"], cwd=lab.path, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.PIPE, text=True)
        time.sleep(part * whole)
        process.send_signal(signal.SIGINT)
        _, said = process.communicate(timeout=LIMIT)
        codes.append(process.returncode)
        assert_plain(said)
        assert not list((lab.path / "heap").glob("pictures/.*"))
    # On a machine that is suddenly faster the last picture may have been drawn.
    assert set(codes) <= {0, 130, -signal.SIGINT} and codes[0] != 0, codes
