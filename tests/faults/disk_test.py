#!/usr/bin/env python3
"""Disks that fill, files that may not grow, folders that are locked meanwhile.

    disk_test.py limit | full | locked

    limit   the system lets no file grow beyond a part of the story's largest (RLIMIT_FSIZE)
    full    a small disk of its own (tmpfs in a name space of its own; skipped where that is not allowed)
    locked  a user other than the superuser loses the permission to write while a long run writes
"""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

import stories
from faults import EARLIER, contents, faults_of_folder, faults_of_message, faults_of_pairs, limit_files, program, run, stages, start

SKIPPED = 77
NOBODY = 65534


def judge(stage, before, folder, end):
    after = contents(folder)
    found = faults_of_folder(stage, before, after, end.status) + faults_of_pairs(stage, before, after)
    if end.status != 0:
        found += faults_of_message(stage, end, "")
    return [f"{stage.story.name}: {text}" for text in found]


def limited():
    """Files stop growing at a half and at nine tenths of what they would be."""
    told, tried = [], 0
    wanted = [s for s in stories.all_stories().values() if not s.slow and not s.resumes]
    with stages(wanted) as chosen:
        for stage in chosen:
            largest = max(len(stage.whole[name]) for name in stage.story.makes)
            for share in (0.5, 0.9):
                folder = stage.copy("limited", True)
                before = contents(folder)
                end = run(stage.command(True), folder, preexec_fn=limit_files(max(1, int(share * largest))))
                tried += 1
                if end.status == 0:
                    told.append(f"{stage.story.name}: ended well with files of {share:g} of their size")
                told += judge(stage, before, folder, end)
            shutil.rmtree(stage.root)
    return tried, told


def can_mount():
    command = ["unshare", "-rm", "sh", "-c", "mount -t tmpfs -o size=100k none /mnt"]
    return bool(shutil.which("unshare")) and subprocess.run(command, capture_output=True, check=False).returncode == 0


def full():
    """A disk with room for a part of what is written beside what is there."""
    if not can_mount():
        print("skipped: no small disk can be mounted")
        sys.exit(SKIPPED)
    told, tried = [], 0
    names = ("run_binary", "run_hdf5", "run_ascii", "run_several", "convert_npy", "focus", "doppler", "merge", "sweep", "profiles_csv")
    known = stories.all_stories()
    with stages(known[name] for name in names) as chosen:
        for stage in chosen:
            needed = sum(len(content) for name, content in stage.whole.items())
            there = sum(len(content) for content in contents(stage.copy("there", True)).values())
            for share in (0.3, 0.7):
                kilobytes = int((there + share * (needed - there)) / 1024) + 4 * len(stage.whole) + 8
                tried += 1
                told += on_small_disk(stage, kilobytes)
    return tried, told


def on_small_disk(stage, kilobytes):
    """The story is run on the disk, then everything is copied off it."""
    source, out = stage.copy("source", True), stage.root / "out"
    shutil.rmtree(out, ignore_errors=True)
    words = " ".join(f"'{word}'" for word in stage.command(True))
    script = (
        f"mount -t tmpfs -o size={kilobytes}k none /mnt && cp -a '{source}/.' /mnt && cd /mnt && "
        f"'{program()}' {words}; status=$?; cd /; cp -a /mnt '{out}'; umount /mnt; exit $status"
    )
    done = subprocess.run(["unshare", "-rm", "sh", "-c", script], capture_output=True, check=False)
    end = type("End", (), {"status": done.returncode, "err": done.stderr.decode(errors="replace")})
    if not out.exists():
        return [f"{stage.story.name}: the small disk could not be made: {end.err}"]
    return judge(stage, contents(source), out, end)


def locked():
    """The folder may no longer be written while a recording grows in it."""
    if os.geteuid() != 0:
        print("skipped: only the superuser can become another user")
        sys.exit(SKIPPED)
    told, tried = [], 0
    for word, file in (("binary", "sim.bin"), ("hdf5", "sim.h5"), ("ascii", "sim.asc")):
        with tempfile.TemporaryDirectory(prefix="sarsim-locked-") as name:
            folder = pathlib.Path(name)
            (folder / "scene.scr").write_text(stories.moving(20000))
            (folder / file).write_bytes(EARLIER)
            for path in (folder, *folder.iterdir()):
                os.chown(path, NOBODY, NOBODY)
            try:
                process = start(("run", "scene.scr", "--force", "--threads", "1", "--format", word), folder, user=NOBODY)
            except PermissionError:
                print("skipped: the program cannot be started by another user")
                sys.exit(SKIPPED)
            if process.poll() is not None and process.returncode == 126:
                sys.exit(SKIPPED)
            end_s = time.monotonic() + 30
            while time.monotonic() < end_s and process.poll() is None and not any(folder.glob(".*.partial-*")):
                time.sleep(0.002)
            folder.chmod(0o555)
            _, err = process.communicate(timeout=120)
            folder.chmod(0o755)
            tried += 1
            text = err.decode(errors="replace")
            if process.returncode != 1 or file not in text or "Permission denied" not in text:
                told.append(f"{word}: status {process.returncode}, {text!r}")
            if (folder / file).read_bytes() != EARLIER:
                told.append(f"{word}: the earlier result is gone")
            # Nobody can remove the hidden unfinished file from a locked folder; nothing else may be there.
            left = [p.name for p in folder.iterdir() if p.name not in ("scene.scr", file) and ".partial-" not in p.name]
            told += [f"{word}: {name} was left behind" for name in left]
    return tried, told


def main():
    tried, told = {"limit": limited, "full": full, "locked": locked}[sys.argv[1]]()
    for text in told:
        print(text)
    print(f"{tried} runs, {len(told)} failures")
    sys.exit(1 if told else 0)


if __name__ == "__main__":
    main()
