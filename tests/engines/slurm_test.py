#!/usr/bin/env python3
"""examples/engines/slurm.sh, word for word, on a Slurm of two nodes, of which one dies in the middle of a part.

Starts munged, slurmctld and two slurmd of Debian in namespaces: a network, host names and processes of their own, so that a
node with all that runs on it can be killed at once. Skipped (77) without root, namespaces or the packages slurmctld, slurmd,
slurm-client, munge and iproute2.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

from engines_support import RECIPES, bin_folder, expect, expect_done, expect_same, program, run, skip, write_scene

PROGRAMS = ("slurmctld", "slurmd", "munged", "sbatch", "squeue", "scontrol", "ip", "unshare")
NAMESPACES = ("unshare", "--net", "--uts", "--mount", "--pid", "--fork", "--mount-proc", "--kill-child=KILL")
ADDRESS = "10.77.0.1"
PARTS = 6
PULSES = 160_000

CONFIGURATION = """
ClusterName=lab
SlurmctldHost=lab({address})
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket,cred_expire=5
CryptoType=crypto/munge
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool-%n
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd-%n.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd-%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=batch_sched_delay=0,sched_interval=1,bf_interval=1
MpiDefault=none
ReturnToService=2
SlurmdTimeout=2
MessageTimeout=2
TCPTimeout=1
NodeName=node[1-2] NodeHostname=lab NodeAddr={address} Port=17001-17002 CPUs=1 State=UNKNOWN
PartitionName=all Nodes=node[1-2] Default=YES MaxTime=INFINITE State=UP
"""


class Slurm:
    """A cluster of two nodes for as long as the test takes."""

    def __init__(self, folder):
        self.folder = folder
        self.daemons = {}
        self.environment = dict(os.environ, SLURM_CONF=str(folder / "slurm.conf"), SCRATCH=str(folder / "scratch"))
        self.environment["PATH"] = f"{bin_folder(folder)}:{os.environ['PATH']}"
        for name in ("state", "spool-node1", "spool-node2", "scratch"):
            (folder / name).mkdir()
        (folder / "slurm.conf").write_text(CONFIGURATION.format(folder=folder, address=ADDRESS))
        (folder / "cgroup.conf").write_text(f"CgroupPlugin=cgroup/v1\nCgroupMountpoint={folder}\n")
        key = folder / "munge.key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o400)

    def start(self, name, *words):
        log = open(self.folder / f"{name}.out", "w")
        self.daemons[name] = subprocess.Popen(
            [str(w) for w in words], env=self.environment, stdout=log, stderr=subprocess.STDOUT
        )

    def __enter__(self):
        f = self.folder
        self.start("munged", "munged", "--foreground", "--force", f"--socket={f}/munge.socket",
                   f"--key-file={f}/munge.key", f"--pid-file={f}/munge.pid", f"--log-file={f}/munge.log",
                   f"--seed-file={f}/munge.seed")
        for _ in range(100):
            if (f / "munge.socket").exists():
                break
            time.sleep(0.05)
        self.start("slurmctld", "slurmctld", "-D", "-i")
        for node in ("node1", "node2"):
            self.start(node, "unshare", "--uts", "--mount", "--pid", "--fork", "--mount-proc", "--kill-child=KILL", "sh",
                       "-c", f"hostname {node}; exec slurmd -D -N {node}")
        return self

    def __exit__(self, *_):
        for daemon in self.daemons.values():
            daemon.kill()
            daemon.wait()

    def kill_node(self, name):
        """With everything that runs on it, as if its power failed."""
        self.daemons[name].kill()
        self.daemons[name].wait()

    def ask(self, *words):
        return run(words, env=self.environment, cwd=self.folder)

    def ready(self, seconds=20):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            if any(daemon.poll() is not None for daemon in self.daemons.values()):
                return False
            if self.ask("scontrol", "show", "node").stdout.count("State=IDLE") == 2:
                return True
            time.sleep(0.1)
        return False

    def submit(self, *words):
        return expect_done(self.ask("sbatch", "--parsable", *words)).stdout.strip()

    def wait(self, seconds=40):
        end = time.monotonic() + seconds
        while self.ask("squeue", "--noheader", "--array").stdout.strip():
            expect(time.monotonic() < end, "the jobs do not end\n" + self.ask("squeue", "--array").stdout + self.logs())
            time.sleep(0.1)

    def logs(self):
        paths = [*self.folder.glob("*.out"), *self.folder.glob("slurm*.log")]
        return "\n".join(f"{p.name}:\n{p.read_text()[-2000:]}" for p in paths)


def part_on(node, parts):
    """The journal of a part that a node has begun."""
    for journal in parts.glob("*.journal"):
        if f"maker {node}, process" in journal.read_text():
            return journal
    return None


def network():
    for step in (
        ["hostname", "lab"],
        ["ip", "link", "set", "lo", "up"],
        ["ip", "link", "add", "lab0", "type", "veth", "peer", "name", "lab1"],
        ["ip", "addr", "add", ADDRESS + "/24", "dev", "lab0"],
        ["ip", "link", "set", "lab0", "up"],
        ["ip", "link", "set", "lab1", "up"],
    ):
        done = run(step)
        if done.returncode != 0:
            skip(f"{' '.join(step)}: {done.stderr.strip()}")


def killed_in_the_middle(slurm, folder):
    array = slurm.submit(f"--array=1-{PARTS}", "--cpus-per-task=1", RECIPES / "slurm.sh")
    parts = folder / "scratch" / "run1" / "sim.bin.parts"
    end = time.monotonic() + 30
    while not (journal := part_on("node2", parts)):
        expect(time.monotonic() < end, "node2 makes no part\n" + slurm.logs())
        time.sleep(0.02)
    slurm.kill_node("node2")
    number = re.search(r"part-(\d+)-of", journal.name)[1]
    expect(not (folder / "scratch" / "run1" / "sim.bin").exists(), "the recording was complete before the node died")
    # Slurm takes some seconds to notice.
    expect_done(run([program(), "run", "scene.toml", "--out", "whole", "--threads", "1"], cwd=folder))
    slurm.wait()
    element = slurm.ask("scontrol", "show", "job", f"{array}_{number}").stdout
    expect("Restarts=1" in element, f"part {number} was not requeued:\n{element}{slurm.logs()}")
    expect("JobState=COMPLETED" in element and "NodeList=node1" in element, f"part {number}:\n{element}{slurm.logs()}")
    expect_same(folder / "whole" / "sim.bin", folder / "scratch" / "run1" / "sim.bin")
    return number


def inside():
    network()
    with tempfile.TemporaryDirectory(prefix="sarsim-slurm-") as name:
        folder = pathlib.Path(name)
        folder.chmod(0o755)
        write_scene(folder, PULSES)
        with Slurm(folder) as slurm:
            if not slurm.ready():
                skip("the daemons of Slurm do not come up here:\n" + slurm.logs())
            number = killed_in_the_middle(slurm, folder)
    print(f"Slurm: node2 died while it made part {number} of {PARTS}; requeued, finished on node1: bytes of a single run")


def main():
    if sys.argv[1:] == ["--inside"]:
        inside()
        return
    missing = [name for name in PROGRAMS if shutil.which(name) is None]
    if missing:
        skip(f"there is no {', '.join(missing)}")
    if os.geteuid() != 0 or run([*NAMESPACES, "true"]).returncode != 0:
        skip("a Slurm of its own needs root and namespaces")
    sys.stdout.flush()
    os.execvp(NAMESPACES[0], [*NAMESPACES, sys.executable, "-B", __file__, "--inside"])


if __name__ == "__main__":
    main()
