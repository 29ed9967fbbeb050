# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The server of `repose view`: its answers are those of the files, and nobody else is answered."""

import base64
import http.client
import json
import os
import re
import shutil
import signal
import socket
import struct
import subprocess
import threading
import time
import zlib
from contextlib import contextmanager
from pathlib import Path
from urllib.parse import urlsplit

import h5py
import numpy as np
import pytest
from conftest import HEAP, PROGRAM, datasets, everything_in, summary

SCENE = HEAP + "[output]\nframes = 20\n"
LONG = SCENE.replace("at_rest = 1e-6\ntime = 500", "time = 1e7")  # until it is killed
TYPES = {"f32": "<f4", "u32": "<u4", "u16": "<u2", "u8": "u1"}
WALL = 2**32 - 1  # less the number of the wall


class View:
    """A running server, and what its addresses answer."""

    def __init__(self, process, address):
        parts = urlsplit(address)
        self.process, self.address, self.port, self.path = process, address, parts.port, parts.path

    def raw(self, path, method="GET", host=None):
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=30)
        connection.putrequest(method, path, skip_host=host is not None)
        if host is not None:
            connection.putheader("Host", host)
        connection.endheaders()
        answer = connection.getresponse()
        body = answer.read()
        connection.close()
        return answer.status, body, answer

    def get(self, name):
        status, body, _ = self.raw(self.path + name)
        assert status == 200, (name, status, body)
        return body

    def json(self, name):
        return json.loads(self.get(name))

    def arrays(self, name):
        return decoded(self.get(name))

    def events(self, of="api/"):
        """Yields (event, data) as they come."""
        with socket.create_connection(("127.0.0.1", self.port), timeout=60) as connection:
            connection.sendall(f"GET {self.path}{of}events HTTP/1.1\r\nHost: 127.0.0.1:{self.port}\r\n\r\n".encode())
            text = ""
            while True:
                part = connection.recv(4096)
                if not part:
                    return
                text += part.decode()
                while found := re.search(r"event: (\w+)\ndata: (.*)\n\n", text):
                    yield found[1], json.loads(found[2])
                    text = text[found.end():]


def decoded(message):
    """Header and arrays of a message."""
    assert message[:4] == b"RPV1"
    length = struct.unpack("<I", message[4:8])[0]
    assert length % 4 == 0
    header, data = json.loads(message[8:8 + length]), message[8 + length:]
    arrays = {}
    for name, one in header["arrays"].items():
        assert one["offset"] % 4 == 0
        count = int(np.prod(one["shape"]))
        values = np.frombuffer(data, TYPES[one["type"]], count, one["offset"]).reshape(one["shape"])
        arrays[name] = one["low"] + one["scale"] * values if "scale" in one else values
    return header, arrays


@contextmanager
def view(folder, *more):
    process = subprocess.Popen([PROGRAM, "view", str(folder), "--no-browser", *more], stdout=subprocess.PIPE,
                               stderr=subprocess.PIPE, text=True)
    address = process.stdout.readline().strip()
    assert address.startswith("http://127.0.0.1:"), process.communicate(timeout=10)
    try:
        yield View(process, address)
    finally:
        process.send_signal(signal.SIGINT)
        try:
            assert process.wait(timeout=30) == 0
        finally:
            process.kill()


@pytest.fixture(scope="module")
def heap(tmp_path_factory):
    from conftest import Laboratory

    lab = Laboratory(tmp_path_factory.mktemp("heap"))
    return lab.run(SCENE)


@pytest.fixture(scope="module")
def shown(heap):
    with view(heap) as server:
        yield server


def test_the_run_is_described_as_its_files_say(shown, heap):
    said, found = shown.json("api/run"), summary(heap)
    assert shown.json("api/folder")["kind"] == "run"
    with h5py.File(heap / "run.h5") as file:
        times = [file[f"frames/{name}"].attrs["time"] for name in sorted(file["frames"])]
        last = file.attrs["time"]
        assert said["released"] == file.attrs["released"] == 40 and said["status"] == "finished"
        force = np.abs(file["contacts/normal_force"][()])
        assert said["force_scale"] == pytest.approx(force[force > 0].mean(), rel=1e-12)
    times = [time for time in times if time < last]
    assert [frame["time"] for frame in said["frames"]] == [*times, last] and len(times) >= 2
    assert said["frames"][-1]["key"] == "last"
    assert json.loads(shown.get("api/summary"))["state_hash"] == found["state_hash"]


def test_frames_are_those_of_the_files(shown, heap):
    for frame in shown.json("api/run")["frames"]:
        header, arrays = shown.arrays(f"api/frame/{frame['key']}")
        path = heap / "run.h5" if frame["key"] == "last" else heap / f"frames/{frame['key']}.h5"
        kept = datasets(path)
        assert header["time"] == frame["time"]
        for name in ("id", "position", "velocity", "spin", "radius"):
            assert np.array_equal(arrays[name], kept[f"/grains/{name}"].astype(arrays[name].dtype)), name
        assert np.array_equal(arrays["flags"], kept["/grains/fixed"] + 2 * kept["/grains/base"].astype(int))
        ids = kept["/grains/id"]
        for side in (0, 1):
            partners = kept["/contacts/grains"][:, side]
            assert np.array_equal(ids[arrays["pair"][:, side]], partners)
        for name in ("normal_force", "tangential_force", "normal", "point"):
            assert np.allclose(arrays[name], kept[f"/contacts/{name}"], rtol=1e-6, atol=1e-9), name


def test_series_and_base_are_those_of_the_files(shown, heap):
    kept = datasets(heap / "run.h5")
    _, series = shown.arrays("api/series")
    for name in ("time", "kinetic_energy_per_grain", "force_residual", "grains", "contacts"):
        assert np.array_equal(series[name], kept[f"/series/{name}"].astype("f4")), name
    _, base = shown.arrays("api/base")
    assert np.array_equal(base["normal"], kept["/base/normal"].astype("f4"))
    # A model has the weight of the base: force per disc at the discs' spacing of one diameter.
    curves = [name for name in base if name.startswith("theory:")]
    assert curves
    for name in curves:
        weight = np.trapz(base[name], base["theory_x"])
        assert weight == pytest.approx(base["normal"].sum(), rel=0.02), name  # the curve ends at 1.2 half-widths
    _, fields = shown.arrays("api/fields")
    stress = datasets(heap / "analysis.h5")["/fields/stress_yy"]
    assert np.array_equal(fields["stress_yy"], stress.astype("f4"), equal_nan=True)


def test_contacts_with_walls_name_them(tmp_path):
    from conftest import Laboratory

    lab = Laboratory(tmp_path)
    out = lab.run("[contact]\nnormal = { law = 'hooke', stiffness = 5e3 }\n[base]\nkind = 'plane'\n[[plane]]\nname = 'left'\n"
                  "point = [-4, 0]\nnormal = [1, 0]\n[[plane]]\npoint = [4, 0]\nnormal = [-1, 0]\n" + HEAP[HEAP.index("[source]"):])
    with view(out) as server:
        header, arrays = server.arrays("api/frame/last")
    partners = datasets(out / "run.h5")["/contacts/grains"][:, 1]
    walls = WALL - arrays["pair"][:, 1].astype(np.int64)
    assert (partners < 0).any() and np.array_equal(walls[partners < 0], -1 - partners[partners < 0])
    assert [wall["name"] for wall in header["walls"]][:2] == ["base", "left"]
    assert header["walls"][1]["from"][0] == header["walls"][1]["to"][0] == -4.0


REFUSED = {
    "no token": ("/", 403), "wrong token": ("/" + "0" * 32 + "/", 403), "short token": ("/0/api/run", 403),
    "no such": ("{}api/nothing", 404), "other folder": ("{}api/frame/../../x", 404), "encoded": ("{}api/frame/%2e%2e%2fx", 404),
    "absolute": ("{}/etc/passwd", 404), "key": ("{}api/frame/1e3", 404), "long key": ("{}api/frame/" + "9" * 400, 404),
    "null": ("{}api/frame/%00", 404), "query": ("{}api/nothing?x=1&y", 404), "members": ("{}api/members/a/run", 404),
}


@pytest.mark.parametrize("name", REFUSED)
def test_other_addresses_are_refused(shown, name):
    path, status = REFUSED[name]
    found, body, _ = shown.raw(path.format(shown.path))
    assert found == status and len(body) < 1000


def test_only_this_machine_and_only_reading(shown):
    for method in ("POST", "PUT", "DELETE", "OPTIONS"):
        assert shown.raw(shown.path, method)[0] in (400, 405)
    assert shown.raw(shown.path + "api/run", host="evil.example")[0] == 403
    assert shown.raw(shown.path + "api/run", host=f"localhost:{shown.port}")[0] == 200
    _, _, answer = shown.raw(shown.path)
    assert "default-src 'none'" in answer.getheader("Content-Security-Policy")
    assert answer.getheader("Referrer-Policy") == "no-referrer" and answer.getheader("Cache-Control") == "no-store"
    listening = [line.split()[1] for name in ("tcp", "tcp6") for line in Path(f"/proc/net/{name}").read_text().splitlines()[1:]
                 if line.split()[3] == "0A"]
    assert [place for place in listening if place.endswith(f":{shown.port:04X}")] == [f"0100007F:{shown.port:04X}"]


@pytest.mark.parametrize("text", [b"", b"\r\n\r\n", b"GET\r\n\r\n", b"GET / HTTP/9.9\r\n\r\n", b"\x00\xff" * 500, b"GET " + b"/x" * 9000 + b" HTTP/1.1\r\n\r\n",
                                  b"GET / HTTP/1.1\r\nContent-Length: -1\r\n\r\n"])
def test_malformed_requests_leave_the_server_well(shown, text):
    with socket.create_connection(("127.0.0.1", shown.port), timeout=20) as connection:
        connection.sendall(text)
        connection.shutdown(socket.SHUT_WR)
        while connection.recv(4096):
            pass
    assert shown.json("api/folder")["kind"] == "run"


def test_a_hundred_clients_and_slow_readers(shown):
    """Sixty listeners that never read and twenty that stop within a frame do not keep a hundred others waiting."""
    idle = [socket.create_connection(("127.0.0.1", shown.port)) for _ in range(80)]
    for k, connection in enumerate(idle):
        name = "api/events" if k < 60 else "api/frame/last"
        connection.sendall(f"GET {shown.path}{name} HTTP/1.1\r\nHost: 127.0.0.1:{shown.port}\r\n\r\n".encode())
    found = []
    clients = [threading.Thread(target=lambda: found.append(len(shown.get("api/frame/last")))) for _ in range(100)]
    for client in clients:
        client.start()
    for client in clients:
        client.join(timeout=60)
    assert len(found) == 100 and len(set(found)) == 1
    for connection in idle:
        connection.close()


def test_listeners_leave_room_for_others(heap):
    """Of 210 listeners 200 are served; the others get an answer that says so, and a page is answered all the same."""
    with view(heap) as server:
        lines = []
        for _ in range(210):
            lines.append(socket.create_connection(("127.0.0.1", server.port)))
            lines[-1].sendall(f"GET {server.path}api/events HTTP/1.1\r\nHost: 127.0.0.1:{server.port}\r\n\r\n".encode())
        statuses = [line.recv(12).split()[1] for line in lines]
        assert statuses.count(b"200") == 200 and statuses.count(b"503") == 10
        assert server.json("api/folder")["kind"] == "run"
        for line in lines:
            line.close()


def test_it_only_reads(heap, tmp_path):
    copy = tmp_path / "copy"
    shutil.copytree(heap, copy)
    before = {name: (copy / name).stat().st_mtime_ns for name in everything_in(copy)}
    for path in [copy, *copy.rglob("*")]:
        path.chmod(0o555 if path.is_dir() else 0o444)
    with view(copy) as server:
        for name in ("", "api/run", "api/series", "api/base", "api/fields", "api/summary", "api/frame/last"):
            server.get(name)
    assert before == {name: (copy / name).stat().st_mtime_ns for name in everything_in(copy)}
    for path in [copy, *copy.rglob("*")]:
        path.chmod(0o755)


def test_a_run_that_goes_on_is_followed_until_its_folder_vanishes(tmp_path):
    (tmp_path / "scene.toml").write_text(LONG)
    run = subprocess.Popen([PROGRAM, "run", "scene.toml", "--out", "out", "--quiet"], cwd=tmp_path)
    try:
        for _ in range(600):
            if (tmp_path / "out/run.h5").exists():
                break
            time.sleep(0.05)
        with view(tmp_path / "out") as server:
            events = server.events()
            first = next(event for event in events if event[1].get("frames"))
            assert first[0] == "change" and first[1]["status"] == "running"
            later = next(event for event in events if event[1].get("frames", 0) > first[1]["frames"] + 1)
            assert later[1]["time"] > first[1]["time"]
            assert len(server.json("api/run")["frames"]) >= later[1]["frames"] - 1
            run.kill()
            run.wait()
            assert server.json("api/run")["frames"][-1]["key"] == "last"
            shutil.rmtree(tmp_path / "out")
            assert next(event for event in events if event[0] == "gone")
            assert server.raw(server.path + "api/run")[0] == 404
    finally:
        run.kill()
        run.wait()


def test_a_damaged_frame_is_left_out(heap, tmp_path):
    copy = tmp_path / "copy"
    shutil.copytree(heap, copy)
    whole = len(json.loads((heap / "summary.json").read_text()))
    assert whole
    path = copy / "frames/000001.h5"
    content = bytearray(path.read_bytes())
    content[len(content) // 2] ^= 1
    path.write_bytes(content)
    with view(heap) as before, view(copy) as server:
        keys = [frame["key"] for frame in server.json("api/run")["frames"]]
        assert [frame["key"] for frame in before.json("api/run")["frames"] if frame["key"] != "000001"] == keys
        assert server.raw(server.path + "api/frame/000001")[0] == 404
        assert server.raw(server.path + "api/frame/last")[0] == 200


def test_a_sweep_and_its_members(tmp_path):
    (tmp_path / "heap.toml").write_text(HEAP)
    (tmp_path / "sweep.toml").write_text('title = "two bases"\nscene = "heap.toml"\nseeds = 2\n[vary]\nbase.spacing = [1.0, 1.1]\n')
    assert subprocess.run([PROGRAM, "sweep", "sweep.toml", "--out", "out", "--quiet"], cwd=tmp_path).returncode == 0
    with view(tmp_path / "out") as server:
        assert server.json("api/folder")["kind"] == "sweep"
        said = server.json("api/sweep")
        assert [member["status"] for member in said["members"]] == ["finished"] * 4 and said["parameters"] == ["base.spacing"]
        assert [point["values"]["base.spacing"] for point in said["points"]] == [1.0, 1.1]
        with h5py.File(tmp_path / "out/sweep.h5") as file:
            for k, means in enumerate(said["means"]):
                mean, error, count = means["coordination"]
                assert mean == pytest.approx(file["measures/coordination/mean"][k], rel=1e-12)
                assert error == pytest.approx(file["measures/coordination/error"][k], rel=1e-9)
                assert count == file["measures/coordination/count"][k] == 2
        name = said["members"][3]["name"]
        assert server.json(f"api/members/{name}/run")["seed"] == 2
        assert len(server.get(f"api/members/{name}/frame/last")) > 1000
        assert next(server.events())[1] == {"finished": 4, "running": 0, "failed": 0}
        assert next(server.events(f"api/members/{name}/"))[1]["status"] == "finished"
        assert server.raw(server.path + "api/members/none/seed-1/events")[0] == 404
        assert server.raw(server.path + f"api/members/{name}/../../x")[0] == 404


def test_a_failed_member_says_why(tmp_path):
    """A source so low and narrow that its own heap reaches it."""
    (tmp_path / "low.toml").write_text(HEAP.replace("height = 10", "height = 3").replace("half_width = 2", "half_width = 0"))
    (tmp_path / "sweep.toml").write_text('scene = "low.toml"\nseeds = 1\n[vary]\ncontact.friction = [0.5]\n')
    assert subprocess.run([PROGRAM, "sweep", "sweep.toml", "--out", "out", "--quiet"], cwd=tmp_path, capture_output=True).returncode == 1
    with view(tmp_path / "out") as server:
        member = server.json("api/sweep")["members"][0]
        assert member["status"] == "failed" and "the source is buried" in member["message"]
        assert server.json(f"api/members/{member['name']}/run")["status"] == "failed"


def test_what_cannot_be_shown_is_said_in_one_line(lab, shown):
    (lab.path / "empty").mkdir()
    assert lab.refused("view", "empty", parts=["empty: holds no run"]).count("\n") == 1
    assert lab.refused("view", "none", parts=["none: no such folder"]).count("\n") == 1
    folder = lab.run(HEAP)
    assert lab.refused("view", folder, "--port", shown.port, parts=[f"--port {shown.port}: is in use"]).count("\n") == 1


def test_a_run_may_be_viewed_while_it_goes_on(tmp_path):
    (tmp_path / "scene.toml").write_text(LONG)
    environment = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}
    run = subprocess.Popen([PROGRAM, "run", "scene.toml", "--out", "out", "--quiet", "--view"], cwd=tmp_path, stdout=subprocess.PIPE,
                           text=True, env=environment)
    address = run.stdout.readline().strip()
    server = View(run, address)
    assert server.json("api/run")["method"] == "soft"
    run.send_signal(signal.SIGINT)
    assert run.wait(timeout=60) == 130
    with pytest.raises(OSError):
        server.raw(server.path)


def test_an_exported_page_has_the_run_in_it(heap, tmp_path):
    out = tmp_path / "page"
    subprocess.run([PROGRAM, "export", str(heap), "--to", "html", "--out", str(out)], check=True, capture_output=True)
    assert everything_in(out) == ["run.html"]
    page = (out / "run.html").read_text()
    data = json.loads(re.search(r'<script type="text/plain" id="repose-data">(.*?)</script>', page, re.S)[1])
    assert "<" not in json.dumps(data["api/run"]["title"])
    kept = datasets(heap / "run.h5")
    keys = [frame["key"] for frame in data["api/run"]["frames"]]
    assert [name[len("api/frame/"):] for name in data if name.startswith("api/frame/")] == keys and keys[-1] == "last"
    _, arrays = decoded(zlib.decompress(base64.b64decode(data["api/frame/last"])))
    for name in ("position", "velocity", "radius"):
        whole = kept[f"/grains/{name}"]
        step = (whole.max() - whole.min()) / 65535
        assert np.abs(arrays[name] - whole).max() <= 0.51 * step + 1e-6 * np.abs(whole).max(), name
    assert np.array_equal(kept["/grains/id"][arrays["pair"]], kept["/contacts/grains"])
    alone = tmp_path / "last"
    subprocess.run([PROGRAM, "export", str(heap), "--to", "html", "--frames", "last", "--out", str(alone)], check=True, capture_output=True)
    assert (alone / "run.html").read_text().count("api/frame/") == 1
