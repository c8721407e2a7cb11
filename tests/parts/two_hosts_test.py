#!/usr/bin/env python3
"""Two hosts, made of network namespaces with a shared folder: MPI runs over both, one is cut off midway, and the run is
resumed on the other. The same with parts.

The programs are SARSIM_BUILT_PROGRAM and SARSIM_BUILT_MPI_PROGRAM of the environment. Skipped (77) where namespaces cannot
be made (it needs root) or there is no MPI; the half without MPI runs on its own.
"""

import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time

from parts_support import SKIPPED, claims, expect, expect_done, expect_same, program, run, write_scene

PULSES = 200_000


class Host:
    """A network and a host name of its own."""

    def __init__(self, number):
        self.name = f"sarsim-{os.getpid()}-{number}"
        self.address = f"10.213.{os.getpid() % 250}.{number}"

    def command(self, *words):
        quoted = " ".join(f"'{w}'" for w in words)
        inside = f"hostname {self.name}; exec {quoted}"
        return ["ip", "netns", "exec", self.name, "unshare", "--uts", "sh", "-c", inside]

    def processes(self):
        """Of the host's sarsim and MPI, oldest first."""
        return [int(p) for p in run(["ip", "netns", "pids", self.name]).stdout.split()]

    def kill(self):
        for pid in self.processes():
            try:
                os.kill(pid, signal.SIGKILL)
            except ProcessLookupError:
                pass


class Network:
    """Two hosts with a cable between them."""

    def __init__(self):
        self.hosts = [Host(1), Host(2)]

    def __enter__(self):
        a, b = self.hosts
        cable = (f"sa{os.getpid() % 100000}", f"sb{os.getpid() % 100000}")
        steps = [["ip", "netns", "add", h.name] for h in self.hosts]
        steps += [["ip", "link", "add", cable[0], "type", "veth", "peer", "name", cable[1]]]
        for host, end in zip(self.hosts, cable):
            inside = ["ip", "-n", host.name]
            steps += [
                ["ip", "link", "set", end, "netns", host.name],
                [*inside, "link", "set", end, "name", "eth0"],
                [*inside, "addr", "add", host.address + "/24", "dev", "eth0"],
                [*inside, "link", "set", "eth0", "up"],
                [*inside, "link", "set", "lo", "up"],
            ]
        for step in steps:
            done = run(step)
            if done.returncode != 0:
                self.__exit__()
                print(f"skipped: {' '.join(step)}: {done.stderr.strip()}")
                sys.exit(SKIPPED)
        expect_done(run(a.command("ping", "-c", "1", "-W", "2", b.address)) if shutil.which("ping") else run(["true"]))
        return self

    def __exit__(self, *_):
        for host in self.hosts:
            host.kill()
            run(["ip", "netns", "del", host.name])

    def cut(self, host):
        """The cable is out, and what ran there is gone."""
        expect_done(run(["ip", "-n", host.name, "link", "set", "eth0", "down"]))
        host.kill()


def claimed(parts):
    return sum(count for journal in parts.glob("*.journal") for _, count in claims(journal))


def wait_for_rows(parts, rows):
    for _ in range(2000):
        if claimed(parts) >= rows:
            return
        time.sleep(0.02)
    expect(False, f"after 40 s only {claimed(parts)} rows")


def parts_on_both(folder):
    words = ["run", "scene.scr", "--out", "by-parts", "--threads", "1", "--quiet", "--save-every", "0.05", "--json"]
    with Network() as network:
        processes = [
            subprocess.Popen(
                host.command(program(), *words, "--part", f"{k}/2"), cwd=folder, stdout=subprocess.PIPE,
                stderr=subprocess.PIPE, text=True,
            )
            for k, host in enumerate(network.hosts, 1)
        ]
        parts = folder / "by-parts" / "sim.bin.parts"
        wait_for_rows(parts, PULSES // 5)
        network.cut(network.hosts[1])
        processes[1].wait(20)
        out, err = processes[0].communicate(timeout=120)
        expect(processes[0].returncode == 0, f"the part of the host that lived has failed: {err}")
        expect(not json.loads(out)["products"][0]["complete"], "the scene is too small: both had finished")
        known = claimed(parts)
        again = expect_done(run(network.hosts[0].command(program(), *words, "--part", "2/2", "--resume"), cwd=folder))
        part = json.loads(again.stdout)["products"][0]
        expect(part["computed_rows"] == PULSES - known, f"{part['computed_rows']} computed, {known} of {PULSES} known")
    expect_same(folder / "whole" / "sim.bin", folder / "by-parts" / "sim.bin")
    return known


def mpi_on_both(folder):
    words = ["run", "scene.scr", "--out", "by-mpi", "--threads", "1", "--resume", "--save-every", "0.05", "--json"]
    mpi_program = os.environ["SARSIM_BUILT_MPI_PROGRAM"]
    with Network() as network:
        a, b = network.hosts
        # In place of ssh: the host's network and name.
        agent = folder / "agent"
        agent.write_text(
            "#!/bin/sh\n"
            f"while [ \"${{1#-}}\" != \"$1\" ]; do shift; done\n"
            f"address=$1; shift\n"
            f"case $address in {a.address}) name={a.name} ;; *) name={b.name} ;; esac\n"
            f"exec ip netns exec $name unshare --uts sh -c \"hostname $name; cd '{folder}'; $*\"\n"
        )
        agent.chmod(0o755)
        mpirun = [
            "mpirun", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none", "--mca", "plm_rsh_agent", str(agent),
            "--mca", "btl", "self,tcp", "--mca", "oob_tcp_if_include", "eth0", "--mca", "btl_tcp_if_include", "eth0",
            "--mca", "pml", "ob1", "-host", f"{a.address}:2,{b.address}:2", "-n", "4", mpi_program,
        ]
        process = subprocess.Popen(
            a.command(*mpirun, *words), cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
        )
        parts = folder / "by-mpi" / "sim.bin.parts"
        wait_for_rows(parts, PULSES // 5)
        makers = {line.split()[1] for p in parts.glob("*.journal") for line in p.read_text().splitlines()
                  if line.startswith("maker ")}
        expect(makers == {a.name + ",", b.name + ","}, f"not both hosts compute but {makers}")
        network.cut(b)
        try:
            _, err = process.communicate(timeout=20)
        except subprocess.TimeoutExpired:  # Nobody tells mpirun of a cable that is out.
            a.kill()
            _, err = process.communicate()
        expect(process.returncode != 0, f"the loss of a host was not noticed\n{err}")
        expect(not (folder / "by-mpi" / "sim.bin").exists(), "an unfinished file has its name")
        known = claimed(parts)
        again = expect_done(run(a.command(program(), *words), cwd=folder))
        part = json.loads(again.stdout)["products"][0]
        expect(part["computed_rows"] == PULSES - known, f"{part['computed_rows']} computed, {known} of {PULSES} known")
    expect_same(folder / "whole" / "sim.bin", folder / "by-mpi" / "sim.bin")
    return known


def main():
    if os.geteuid() != 0 or shutil.which("ip") is None or shutil.which("unshare") is None:
        print("skipped: network namespaces need root, ip and unshare")
        sys.exit(SKIPPED)
    with tempfile.TemporaryDirectory(prefix="sarsim-hosts-") as name:
        folder = pathlib.Path(name)
        write_scene(folder, PULSES)
        expect_done(run([program(), "run", "scene.scr", "--out", "whole"], cwd=folder))
        known = parts_on_both(folder)
        print(f"parts: a host was cut off, {known} of {PULSES} rows were known, the other went on: same bytes")
        if shutil.which("mpirun") is None or not os.environ.get("SARSIM_BUILT_MPI_PROGRAM"):
            print("MPI over both hosts was left out: there is no mpirun, or sarsim-mpi was not built")
            return
        known = mpi_on_both(folder)
        print(f"MPI: a host was cut off, {known} of {PULSES} rows were known, the other went on: same bytes")


if __name__ == "__main__":
    main()
