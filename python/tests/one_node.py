"""A cluster of Slurm on this machine, for as long as a test: controller, one node, and their keys, all in a folder."""

from __future__ import annotations

import os
import shutil
import socket
import subprocess
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

PROGRAMS = ("munged", "slurmctld", "slurmd", "sbatch", "sinfo")

SETTINGS = """\
ClusterName=one
SlurmctldHost={host}
SlurmctldPort={port}
SlurmdPort={other}
SlurmUser=root
SlurmdUser=root
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldLogFile={folder}/controller.log
SlurmdLogFile={folder}/node.log
SlurmctldPidFile={folder}/controller.pid
SlurmdPidFile={folder}/node.pid
AuthType=auth/munge
AuthInfo=socket={folder}/munge/socket
CryptoType=crypto/munge
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
NodeName={host} CPUs={processors} State=UNKNOWN
PartitionName=all Nodes={host} Default=YES State=UP MaxTime=INFINITE
"""


@contextmanager
def one_node(folder: Path) -> Iterator[str | None]:
    """Gives the path of the cluster's settings (``SLURM_CONF``); ``None`` where it cannot start: without its programs, or as another user than
    root."""
    path = os.pathsep.join([os.environ.get("PATH", ""), "/usr/sbin", "/usr/bin"])
    if os.geteuid() != 0 or any(shutil.which(program, path=path) is None for program in PROGRAMS):
        yield None
        return
    for name in ("state", "spool", "munge"):
        (folder / name).mkdir(parents=True)
    # every folder above the socket must be of root alone to write
    for own in (folder, folder / "munge"):
        own.chmod(0o755)
    key = folder / "munge" / "key"
    key.write_bytes(os.urandom(1024))
    key.chmod(0o400)
    settings = folder / "slurm.conf"
    host = socket.gethostname().split(".")[0]
    ports = free_ports(2)
    settings.write_text(
        SETTINGS.format(host=host, folder=folder, processors=os.cpu_count() or 1, port=ports[0], other=ports[1])
    )
    keys = [
        f"--key-file={key}",
        f"--socket={folder}/munge/socket",
        f"--pid-file={folder}/munge/pid",
        f"--log-file={folder}/munge/log",
        f"--seed-file={folder}/munge/seed",
    ]
    surroundings = {**os.environ, "PATH": path, "SLURM_CONF": str(settings)}
    quiet = {"env": surroundings, "stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    started = [
        subprocess.Popen(words, **quiet)  # type: ignore[call-overload]
        for words in (["munged", "--foreground", "--force", *keys], ["slurmctld", "-D"], ["slurmd", "-D"])
    ]
    try:
        yield str(settings) if is_free(surroundings) else None
    finally:
        for process in reversed(started):
            process.terminate()
        for process in started:
            process.wait(20)


def is_free(surroundings: dict[str, str]) -> bool:
    """Returns true once the cluster has a node that takes work, false if it has none after half a minute."""
    for _ in range(60):
        words = ["sinfo", "--noheader", "--states=idle"]
        nodes = subprocess.run(words, env=surroundings, capture_output=True, text=True, check=False)
        if nodes.returncode == 0 and nodes.stdout.strip():
            return True
        time.sleep(0.5)
    return False


def free_ports(count: int) -> list[int]:
    """Returns ports that nobody listens on."""
    sockets = [socket.socket() for _ in range(count)]
    for own in sockets:
        own.bind(("127.0.0.1", 0))
    ports = [own.getsockname()[1] for own in sockets]
    for own in sockets:
        own.close()
    return ports
