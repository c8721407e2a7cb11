#!/usr/bin/env python3
"""An array job of Slurm makes a recording in 8 parts, and another one parts in files of their own, which are merged.

Starts munged, slurmctld and slurmd of Debian on this machine, with a configuration and folders of its own, and ends them.
Skipped (77) where that is not possible: it needs root and the packages slurmctld, slurmd, slurm-client and munge, and no
Slurm that runs here already.
"""

import os
import pathlib
import shutil
import socket
import subprocess
import sys
import tempfile
import time

from parts_support import SKIPPED, expect, expect_done, expect_same, program, run, write_scene

PROGRAMS = ("slurmctld", "slurmd", "munged", "sbatch", "squeue", "scontrol")

CONFIGURATION = """
ClusterName=lab
SlurmctldHost={host}(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
CryptoType=crypto/munge
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
SlurmctldPort={port}
SlurmdPort={port_of_node}
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerType=sched/backfill
MpiDefault=none
ReturnToService=2
NodeName={host} NodeAddr=127.0.0.1 CPUs={cpus} State=UNKNOWN
PartitionName=all Nodes={host} Default=YES MaxTime=INFINITE State=UP
"""


def skip(why):
    print(f"skipped: {why}")
    sys.exit(SKIPPED)


def free_port():
    with socket.socket() as s:
        s.bind(("127.0.0.1", 0))
        return s.getsockname()[1]


class Slurm:
    """A cluster of one machine for as long as the test takes."""

    def __init__(self, folder):
        self.folder = folder
        self.daemons = []
        self.environment = dict(os.environ, SLURM_CONF=str(folder / "slurm.conf"))
        for name in ("state", "spool"):
            (folder / name).mkdir()
        text = CONFIGURATION.format(
            host=socket.gethostname().split(".")[0], folder=folder, port=free_port(), port_of_node=free_port(),
            cpus=os.cpu_count(),
        )
        (folder / "slurm.conf").write_text(text)
        key = folder / "munge.key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o400)

    def start(self, *words):
        log = open(self.folder / (words[0] + ".out"), "w")
        self.daemons.append(
            subprocess.Popen([str(w) for w in words], env=self.environment, stdout=log, stderr=subprocess.STDOUT)
        )

    def __enter__(self):
        f = self.folder
        self.start("munged", "--foreground", "--force", f"--socket={f}/munge.socket", f"--key-file={f}/munge.key",
                   f"--pid-file={f}/munge.pid", f"--log-file={f}/munge.log", f"--seed-file={f}/munge.seed")
        time.sleep(0.5)
        self.start("slurmctld", "-D", "-i")
        self.start("slurmd", "-D", "-N", socket.gethostname().split(".")[0])
        return self

    def __exit__(self, *_):
        for daemon in reversed(self.daemons):
            daemon.terminate()
        for daemon in self.daemons:
            try:
                daemon.wait(10)
            except subprocess.TimeoutExpired:
                daemon.kill()
                daemon.wait()

    def ask(self, *words):
        return run(words, env=self.environment, cwd=self.folder)

    def ready(self, seconds=40):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            if any(daemon.poll() is not None for daemon in self.daemons):
                return False
            node = self.ask("scontrol", "show", "node")
            if "State=IDLE" in node.stdout:
                return True
            time.sleep(0.5)
        return False

    def submit(self, name, text, *options):
        script = self.folder / name
        script.write_text(text)
        return expect_done(self.ask("sbatch", "--parsable", *options, script)).stdout.strip()

    def wait(self, seconds=150):
        end = time.monotonic() + seconds
        while self.ask("squeue", "--noheader").stdout.strip():
            expect(time.monotonic() < end, "the jobs do not end\n" + self.ask("squeue").stdout)
            time.sleep(0.5)

    def logs(self):
        return "\n".join(p.read_text()[-2000:] for p in self.folder.glob("*.out")) + "\n".join(
            p.read_text()[-2000:] for p in self.folder.glob("slurm*.log")
        )


ARRAY = """#!/bin/bash
#SBATCH --array=1-8 --cpus-per-task=1 --requeue
cd {work}
{program} run scene.scr --out shared --threads $SLURM_CPUS_PER_TASK --quiet \\
  --part $SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT --resume || exit
{program} run scene.scr --out own-$SLURM_ARRAY_TASK_ID --threads $SLURM_CPUS_PER_TASK --quiet --format hdf5 \\
  --part $SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT --part-file
"""

MERGE = """#!/bin/bash
cd {work}
{program} merge own-*/sim.h5.parts -o merged.h5 --remove
"""


def main():
    missing = [name for name in PROGRAMS if shutil.which(name) is None]
    if missing:
        skip(f"there is no {', '.join(missing)}")
    if os.geteuid() != 0:
        skip("the daemons of Slurm can only be started by root")
    with tempfile.TemporaryDirectory(prefix="sarsim-slurm-") as name:
        folder = pathlib.Path(name)
        folder.chmod(0o755)
        work = folder / "work"
        work.mkdir()
        write_scene(work, 4000)
        expect_done(run([program(), "run", "scene.scr", "--out", "whole"], cwd=work))
        expect_done(run([program(), "run", "scene.scr", "--out", "whole", "--format", "hdf5"], cwd=work))
        with Slurm(folder) as slurm:
            if not slurm.ready():
                skip("the daemons of Slurm do not come up here:\n" + slurm.logs())
            words = {"work": work, "program": program()}
            array = slurm.submit("array.sh", ARRAY.format(**words))
            slurm.submit("merge.sh", MERGE.format(**words), f"--dependency=afterok:{array}")
            slurm.wait()
        outputs = "\n".join(p.read_text() for p in sorted(folder.glob("slurm-*.out")))
        expect((work / "shared" / "sim.bin").exists(), "the array job has made no file\n" + outputs)
        expect_same(work / "whole" / "sim.bin", work / "shared" / "sim.bin")
        expect_same(work / "whole" / "sim.h5", work / "merged.h5")
        expect(not list(work.glob("own-*/sim.h5.parts")), "the parts were not removed")
    print("Slurm: an array job of 8 parts and a merge give the bytes of a single run")


if __name__ == "__main__":
    main()
