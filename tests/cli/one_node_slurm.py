# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Slurm on this machine alone: its own configuration, key, ports and files in one folder, no root, no cgroups."""

import getpass
import os
import secrets
import shutil
import socket
import subprocess
import time
from contextlib import contextmanager
from pathlib import Path

PATH = os.environ.get("PATH", "") + ":/usr/sbin:/sbin"  # where Debian has the daemons
PROGRAMS = ("munged", "slurmctld", "slurmd", "sbatch", "scontrol", "sinfo", "squeue", "scancel")

# A requeued job waits for the end of its credential, which lasts two minutes by default. Partition `urgent` preempts
# jobs of the other one.
CONFIGURATION = """ClusterName=one
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={controller_port}
SlurmdPort={node_port}
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket,cred_expire=5
CredType=cred/munge
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SlurmdParameters=config_overrides
SchedulerParameters=sched_interval=2
PreemptType=preempt/partition_prio
PreemptMode=REQUEUE
KillWait=30
MinJobAge=7200
ReturnToService=2
NodeName={host} NodeAddr=127.0.0.1 CPUs=4 State=UNKNOWN
PartitionName=work Nodes={host} Default=YES MaxTime=INFINITE State=UP PriorityTier=1
PartitionName=urgent Nodes={host} MaxTime=INFINITE State=UP PriorityTier=2
"""


class CannotStart(Exception):
    """Why no Slurm runs here."""


def free_ports(count):
    sockets = [socket.create_server(("127.0.0.1", 0)) for _ in range(count)]
    ports = [listener.getsockname()[1] for listener in sockets]
    for listener in sockets:
        listener.close()
    return ports


class Slurm:
    """A running Slurm; its commands find it by `environment`."""

    def __init__(self, folder):
        self.folder = folder
        self.environment = {**os.environ, "PATH": PATH, "SLURM_CONF": str(folder / "slurm.conf")}

    def ask(self, *words):
        """What a command of Slurm prints, which must succeed."""
        result = subprocess.run(words, env=self.environment, capture_output=True, text=True, timeout=60)
        assert result.returncode == 0, f"{words}: {result.stdout}{result.stderr}"
        return result.stdout

    def states(self):
        """The states of all tasks that Slurm remembers."""
        return {line.split()[0]: line.split()[1] for line in
                self.ask("squeue", "--all", "--array", "--noheader", "--states=all", "--format=%i %T").splitlines()}

    def wait_for(self, condition, seconds):
        """Waits until a condition on the states of the tasks holds."""
        end = time.monotonic() + seconds
        while not condition(self.states()):
            assert time.monotonic() < end, f"tasks {self.states()} after {seconds} s\n{self.log()}"
            time.sleep(0.2)

    def log(self):
        return "".join(path.read_text(errors="replace")[-3000:] for path in sorted(self.folder.glob("*.log")))


def answers(slurm, daemons):
    """Whether the node is ready. Raises CannotStart if a daemon has ended."""
    for daemon in daemons:
        if daemon.poll() is not None:
            raise CannotStart(f"{daemon.args[3]} ends with {daemon.returncode}: {slurm.log()[-800:]}")
    result = subprocess.run(["sinfo", "--noheader", "--format=%T", "--partition=work"], env=slurm.environment,
                            capture_output=True, text=True)
    return result.stdout.strip() == "idle"


@contextmanager
def one_node_slurm(folder):
    """Starts munged, slurmctld and slurmd; ends them, and what they run, afterwards, also where the test is killed.
    Raises CannotStart."""
    missing = [name for name in PROGRAMS if not shutil.which(name, path=PATH)]
    if missing:
        raise CannotStart(f"not installed: {', '.join(missing)}")
    folder = Path(folder)
    host = socket.gethostname().split(".")[0]
    controller_port, node_port = free_ports(2)
    for name in ("state", "spool"):
        (folder / name).mkdir(parents=True)
    (folder / "slurm.conf").write_text(CONFIGURATION.format(
        host=host, user=getpass.getuser(), folder=folder, controller_port=controller_port, node_port=node_port))
    (folder / "munge.key").write_bytes(secrets.token_bytes(128))
    (folder / "munge.key").chmod(0o600)
    slurm = Slurm(folder)
    commands = [
        ["munged", "--foreground", "--force", f"--socket={folder}/munge.socket", f"--key-file={folder}/munge.key",
         f"--pid-file={folder}/munged.pid", f"--seed-file={folder}/munge.seed", f"--log-file={folder}/munged.log"],
        ["slurmctld", "-D", "-i"],
        ["slurmd", "-D"],
    ]
    daemons = []
    try:
        for words in commands:
            with open(folder / f"{words[0]}.log", "ab") as log:
                tied = ["setpriv", "--pdeathsig", "TERM", *words]
                daemons.append(subprocess.Popen(tied, env=slurm.environment, stdout=log, stderr=log))
            end = time.monotonic() + 20
            while words[0] == "munged" and not (folder / "munge.socket").exists() and time.monotonic() < end:
                time.sleep(0.05)
        end = time.monotonic() + 30
        while not answers(slurm, daemons):
            if time.monotonic() > end:
                raise CannotStart(f"the node is not ready after 30 s: {slurm.log()[-800:]}")
            time.sleep(0.2)
        yield slurm
    finally:
        if len(daemons) == len(commands):
            subprocess.run(["scancel", f"--user={getpass.getuser()}"], env=slurm.environment, capture_output=True)
            time.sleep(2)
        for daemon in reversed(daemons):
            daemon.terminate()
            try:
                daemon.wait(timeout=15)
            except subprocess.TimeoutExpired:
                daemon.kill()
                daemon.wait()
