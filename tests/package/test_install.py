# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""An installation that is moved works from anywhere, without hints in the environment; packages hold the same files."""

import json
import os
import re
import shutil
import subprocess
import tarfile
from pathlib import Path

import pytest

BUILD = Path(os.environ.get("REPOSE_BUILD", ""))
SOURCE = Path(__file__).resolve().parents[2]
CLEAN = {name: os.environ[name] for name in ("PATH", "HOME") if name in os.environ}
SCENE = """[base]
kind = "row"
half_width = 8
[source]
kind = "pour"
count = 40
rate = 1.0
height = 10
half_width = 2
[stop]
at_rest = 1e-6
time = 500
"""
PYTHON = "lib/python3/dist-packages"


def done(*words, cwd=None, **environment):
    """Standard output of a command that must end well."""
    result = subprocess.run([str(word) for word in words], cwd=cwd, env={**CLEAN, **environment}, capture_output=True,
                            text=True, timeout=600)
    assert result.returncode == 0, f"{words}: {result.stderr}{result.stdout}"
    return result.stdout


@pytest.fixture(scope="module", autouse=True)
def build():
    assert (BUILD / "cmake_install.cmake").is_file(), "set REPOSE_BUILD to a build folder"


@pytest.fixture(scope="module")
def prefix(tmp_path_factory):
    """An installation that was moved after it was made."""
    folder = tmp_path_factory.mktemp("install")
    done("cmake", "--install", BUILD, "--prefix", folder / "first")
    return (folder / "first").rename(folder / "moved here")


@pytest.fixture(scope="module")
def program(prefix):
    return prefix / "bin/repose"


@pytest.fixture(scope="module")
def elsewhere(tmp_path_factory):
    """A folder outside the repository, with files that would break Python if it searched here."""
    folder = tmp_path_factory.mktemp("elsewhere")
    (folder / "scene.toml").write_text(SCENE)
    (folder / "repose").mkdir()
    for name in ("numpy.py", "json.py", "repose_compiled.py", "repose/__init__.py"):
        (folder / name).write_text("raise SystemExit('a module of the current folder')\n")
    return folder


@pytest.fixture(scope="module")
def heap(program, elsewhere):
    done(program, "run", "scene.toml", "--out", "heap", "--quiet", cwd=elsewhere)
    return elsewhere / "heap"


def test_run(heap):
    assert json.loads((heap / "summary.json").read_text())["status"] == "finished"


def test_plot(program, heap, elsewhere):
    done(program, "plot", "heap", "--only", "heap", "--format", "png", cwd=elsewhere)
    assert (heap / "pictures/heap.png").stat().st_size > 1000


def test_plot_of_a_theory(program, elsewhere):
    done(program, "theory", "pile-continuum", "--plot", "pile.png", cwd=elsewhere)
    assert (elsewhere / "pile.png").stat().st_size > 1000


def test_the_program_finds_the_package_beside_it(program, prefix, elsewhere):
    words = done(program, "plot", "heap", cwd=elsewhere, REPOSE_PYTHON=shutil.which("echo"))
    assert words.split("\n")[-2].endswith(f" repose.plot {prefix / PYTHON} heap")
    named = done(program, "plot", "heap", REPOSE_PYTHON=shutil.which("echo"), REPOSE_PYTHON_PATH="/some/where")
    assert named.split("\n")[-2].endswith(" repose.plot /some/where heap")


def test_a_link_to_the_program_works(program, prefix, tmp_path):
    (tmp_path / "repose").symlink_to(program)
    words = done(tmp_path / "repose", "plot", "heap", REPOSE_PYTHON=shutil.which("echo"))
    assert f" {prefix / PYTHON} " in words


def test_a_program_without_its_package_says_so(program, tmp_path):
    shutil.copy(program, tmp_path / "repose")
    result = subprocess.run([tmp_path / "repose", "plot", "heap"], env=CLEAN, capture_output=True, text=True, timeout=600)
    assert result.returncode == 1 and "the Python package is neither in" in result.stderr


def test_python_package(prefix, heap):
    """In Python, without the program."""
    code = f"import repose; print(len(repose.open({str(heap)!r}).state.grains))"
    assert int(done("/usr/bin/python3", "-c", code, PYTHONPATH=str(prefix / PYTHON))) > 40


def test_help_manual_page_completion_and_documents(program, prefix):
    assert "repose run examples/heap.toml" in done(program, "--help")
    for file, words in {
        "share/man/man1/repose.1": ["--man"],
        "share/bash-completion/completions/repose": ["--completion", "bash"],
        "share/zsh/vendor-completions/_repose": ["--completion", "zsh"],
    }.items():
        assert (prefix / file).read_text() == done(program, *words)
    for name in ("LICENSE", "CITATION.cff"):
        assert (prefix / "share/doc/repose" / name).read_bytes() == (SOURCE / name).read_bytes()
    installed = prefix / "share/repose/examples"
    assert files_below(installed) == files_below(SOURCE / "examples")
    done(program, "check", installed / "heap.toml")


def test_one_version_everywhere(program, prefix):
    version = done(program, "--version").strip()
    assert f'set(PACKAGE_VERSION "{version}")' in next(prefix.rglob("repose-config-version.cmake")).read_text()
    assert f"version: {version}\n" in (prefix / "share/doc/repose/CITATION.cff").read_text()


def test_nothing_installed_names_the_build_or_the_source(prefix):
    """Binaries may carry such paths in what debuggers read; text may not."""
    for file in prefix.rglob("*"):
        if file.is_file() and file.suffix not in (".a", ".so") and file.parent.name != "bin":
            text = file.read_bytes()
            assert str(SOURCE).encode() not in text and str(BUILD).encode() not in text, file


def test_the_example_in_cpp_builds_and_pours_the_heap_of_the_program(program, prefix, elsewhere):
    """`find_package` finds the installed library; its heap has the angle that the program measures."""
    shutil.copytree(prefix / "share/repose/examples/cpp", elsewhere / "cpp")
    done("cmake", "-S", "cpp", "-B", "cpp/build", f"-DCMAKE_PREFIX_PATH={prefix}", cwd=elsewhere)
    done("cmake", "--build", "cpp/build", cwd=elsewhere)
    lines = done("cpp/build/heap", cwd=elsewhere).splitlines()
    assert re.fullmatch(r"time  10.0: +\d+ grains, +\d+ contacts", lines[0]) and len(lines) == 7
    keys = re.findall(r'\.set\("(\S+)", (.*)\)$', (elsewhere / "cpp/heap.cpp").read_text(), flags=re.M)
    (elsewhere / "same.toml").write_text("".join(f"{key} = {value}\n" for key, value in keys))
    done(program, "run", "same.toml", "--out", "same", "--quiet", cwd=elsewhere)
    angle = json.loads((elsewhere / "same/summary.json").read_text())["angle_of_repose_deg"]["mean"]
    assert lines[-1] == f"angle of repose {angle:.1f} degrees"


def files_below(folder):
    """Files by their paths below a folder, but for what Python compiles as it runs."""
    files = {file.relative_to(folder) for file in folder.rglob("*") if file.is_file()}
    return {str(file) for file in files if "__pycache__" not in file.parts}


@pytest.fixture(scope="module")
def packages(tmp_path_factory):
    folder = tmp_path_factory.mktemp("packages")
    generators = "TGZ;DEB" if shutil.which("dpkg-shlibdeps") else "TGZ"
    done("cpack", "--config", BUILD / "CPackConfig.cmake", "-B", folder, "-G", generators)
    return folder


def test_tar_archive(packages, prefix):
    [archive] = packages.glob("repose-*.tar.gz")
    with tarfile.open(archive) as tar:
        tar.extractall(packages / "tar")
    [top] = (packages / "tar").iterdir()
    assert files_below(top) == files_below(prefix)
    assert done(top / "bin/repose", "--version") == done(prefix / "bin/repose", "--version")


@pytest.mark.skipif(not shutil.which("dpkg-shlibdeps"), reason="not a Debian system")
def test_debian_package(packages, prefix):
    [package] = packages.glob("repose_*.deb")
    done("dpkg", "-x", package, packages / "deb")
    assert files_below(packages / "deb/usr") == files_below(prefix)
    assert [child.name for child in (packages / "deb").iterdir()] == ["usr"]
    depends = done("dpkg-deb", "--field", package, "Depends")
    for name in ("libc6", "libhdf5", "libfmt", "voro", "libxxhash", "python3-numpy", "python3-h5py", "python3-matplotlib"):
        assert re.search(rf"(^|, ){re.escape(name)}|lib{re.escape(name)}", depends), f"{name} is not in {depends}"
    words = done(packages / "deb/usr/bin/repose", "plot", "x", REPOSE_PYTHON=shutil.which("echo"))
    assert f" {packages / 'deb/usr' / PYTHON} " in words
