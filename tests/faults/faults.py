"""Runs stories with faults put into their system calls and says what is wrong with how they end."""

import contextlib
import dataclasses
import errno
import fnmatch
import os
import pathlib
import re
import resource
import shutil
import signal
import subprocess
import tempfile

from stories import TIMES

TIME_LIMIT_S = 60
EARLIER = b"what an earlier run has left\n"
WRITES = ("write", "pwrite", "writev")
CREATES = ("open", "mkdir", "rename", "renameat2", "link")
SIZES = ("ftruncate", "fallocate", "posix_fallocate")
SYNCS = ("fsync", "fdatasync")
ALL_CALLS = WRITES + CREATES + SIZES + SYNCS + ("close", "fchmod")


@dataclasses.dataclass(frozen=True)
class Fault:
    """A way for system calls to fail."""

    name: str
    error: int  # 0: a write that is cut short.
    calls: tuple[str, ...]
    stays: bool = False  # All calls from that one on.
    harmless: bool = False  # The command has to go on and end well.
    statuses: tuple[int, ...] = (1, 2)  # With which it may end otherwise.


FAULTS = (
    Fault("no room", errno.ENOSPC, WRITES + SIZES + ("open", "mkdir", "rename", "renameat2", "link"), stays=True),
    Fault("no room once", errno.ENOSPC, WRITES + SIZES),
    Fault("broken disk", errno.EIO, WRITES + SYNCS + SIZES + ("close", "rename", "renameat2", "open")),
    Fault("no permission", errno.EACCES, CREATES + ("fchmod",)),
    Fault("interrupted", errno.EINTR, WRITES + SYNCS + SIZES + ("open",), harmless=True),
    Fault("cut short", 0, WRITES, harmless=True),
    Fault("file server started anew", errno.ESTALE, WRITES + CREATES, statuses=(1, 2, 75)),
)


def program():
    name = os.environ.get("SARSIM_PROGRAM") or os.environ.get("SARSIM_BUILT_PROGRAM")
    if not name:
        raise SystemExit("set SARSIM_PROGRAM to the program to test")
    return os.path.abspath(name)


def library():
    return os.path.abspath(os.environ["SARSIM_FAULTY_CALLS"])


@dataclasses.dataclass
class End:
    """How a command ended."""

    status: int | None
    err: str
    calls: list[tuple[str, str]]  # Name and path of each call that was counted, in order.


def start(command, folder, environment=None, **options):
    streams = {"stdout": subprocess.DEVNULL, "stderr": subprocess.PIPE, "stdin": subprocess.DEVNULL} | options
    return subprocess.Popen([program(), *command], cwd=folder, env=os.environ | (environment or {}), **streams)


def run(command, folder, environment=None, **options):
    log = pathlib.Path(environment["FAULTY_LOG"]) if environment else None
    with start(command, folder, environment, **options) as process:
        try:
            _, err = process.communicate(timeout=TIME_LIMIT_S)
        except subprocess.TimeoutExpired:
            process.kill()
            process.communicate()
            return End(None, "", [])
    lines = log.read_text(errors="replace").splitlines() if log and log.exists() else []
    # Threads that call at the same time may tell it in another order than they were counted in.
    told = sorted((line.split(" ", 2) for line in lines if line.count(" ") >= 2), key=lambda words: int(words[0]))
    calls = [tuple(words[1:]) for words in told]
    return End(process.returncode, err.decode(errors="replace"), calls)


def contents(folder):
    """Every file below a folder with its bytes, except programs' own hidden ones."""
    return {
        str(path.relative_to(folder)): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file() and not path.is_symlink()
    }


def steady(name, content):
    """A content without what differs from run to run."""
    if name.endswith((".html", ".json", ".journal", ".svg", ".pdf", ".png")):
        return TIMES.sub(b"", content)
    return content


class Stage:
    """A story with its folder as it is before the command, and what the command makes of it."""

    def __init__(self, story, root):
        self.story = story
        self.root = pathlib.Path(root)
        self.fresh = self.root / "fresh"
        self.fresh.mkdir()
        for name, text in story.files.items():
            (self.fresh / name).write_bytes(text if isinstance(text, bytes) else text.encode())
        for command in story.before:
            end = run((*command, "--quiet"), self.fresh)
            if end.status != 0:
                raise SystemExit(f"{story.name}: {' '.join(command)}: {end.err}")
        whole = self.copy("whole")
        end = run(self.command(False), whole)
        if end.status != 0:
            raise SystemExit(f"{story.name}: status {end.status} without any fault: {end.err}")
        self.whole = contents(whole)
        missing = [name for name in story.makes if name not in self.whole]
        if missing:
            raise SystemExit(f"{story.name}: {missing} is not made, but {sorted(self.whole)}")

    def command(self, replaces):
        return [*self.story.command, *([self.story.force] if replaces and self.story.force else [])]

    def copy(self, name, earlier=False):
        """A new folder to run in; with results of an earlier run under the names of what is made."""
        folder = self.root / name
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(self.fresh, folder)
        if earlier:
            for made in self.story.makes:
                path = folder / made
                if not path.exists():
                    path.parent.mkdir(parents=True, exist_ok=True)
                    path.write_bytes(EARLIER)
        return folder

    def may_stay(self, name):
        return any(fnmatch.fnmatch(name, pattern) for pattern in self.story.working)

    def is_whole(self, name, content):
        return not self.story.same or steady(name, content) == steady(name, self.whole.get(name, b""))


def faults_of_folder(stage, before, after, status):
    """What is wrong with what a command has left: everything complete, or as it was, and nothing else."""
    found = []
    for name in sorted(set(before) | set(after)):
        old, new = before.get(name), after.get(name)
        if new is None:
            found.append(f"{name} is gone")
        elif name in stage.story.makes:
            if status == 0 and old is not None and new == old and not stage.is_whole(name, new):
                found.append(f"{name} was not made")
            elif new != old and not stage.is_whole(name, new):
                found.append(f"{name} is neither complete nor what it was")
        elif old is None and not stage.may_stay(name) and not (status == 0 and name in stage.whole):
            found.append(f"{name} was left behind")
        elif old is not None and new != old:
            found.append(f"{name} was changed")
    if status == 0:
        found += [f"{name} was not made" for name in stage.story.makes if name not in after]
    return found


def pairs_of(names):
    """Files that only mean something together: an image and its header."""
    return [(n, n[:-4] + ".hdr") for n in names if n.endswith((".img", ".npy")) and n[:-4] + ".hdr" in names]


def faults_of_pairs(stage, before, after):
    found = []
    for image, header in pairs_of(stage.story.makes):
        new = [after.get(name) != before.get(name) for name in (image, header)]
        if new[0] != new[1]:
            found.append(f"of {image} and {header} one is new")
    return found


def names_a_file(err, stage, path):
    """Whether a message names a file that the story makes, its folder, or the path of the call that failed."""
    names = {pathlib.Path(path).name, pathlib.Path(path).parent.name, "temporary file in"}
    for made in (*stage.story.makes, *stage.story.working):
        names |= {pathlib.Path(made).name, *(part for part in pathlib.Path(made).parts)}
    return any(name and name.rstrip("*") in err for name in names)


def faults_of_message(stage, end, path, statuses=(1, 2)):
    found = []
    if end.status not in statuses:
        found.append(f"ended with status {end.status}")
    if not names_a_file(end.err, stage, path):
        found.append(f"the message names no file: {end.err!r}")
    if re.search(r"HDF5-DIAG|terminate called|Sanitizer|runtime error", end.err):
        found.append("the insides of the program show")
    return found


def try_fault(stage, fault, at, earlier):
    """What is wrong after the `at`-th of a fault's calls has failed; None where there is no such call."""
    folder = stage.copy("faulty", earlier)
    before = contents(folder)
    log = stage.root / "log"
    log.unlink(missing_ok=True)
    environment = {
        "LD_PRELOAD": library(),
        "FAULTY_FOLDER": str(folder),
        "FAULTY_CALLS": ",".join(fault.calls) + ",",
        "FAULTY_AT": str(at),
        "FAULTY_WITH": str(fault.error),
        "FAULTY_ON": str(int(fault.stays)),
        "FAULTY_LOG": str(log),
    }
    end = run(stage.command(earlier), folder, environment)
    if len(end.calls) < at:
        return None
    call, path = end.calls[at - 1]
    after = contents(folder)
    if end.status is None:
        found = ["did not end"]
    else:
        found = faults_of_folder(stage, before, after, end.status)
        if call not in ("rename", "renameat2"):
            found += faults_of_pairs(stage, before, after)
        if end.status != 0:
            found += faults_of_message(stage, end, path, fault.statuses)
        if fault.harmless and end.status != 0:
            found.append(f"did not go on: {end.err!r}")
        if end.status == 0 and call in WRITES + SYNCS and not fault.harmless and pathlib.Path(path).is_file():
            found.append("a failure that may have lost data was not told")
    if stage.story.resumes and end.status not in (None, 0):
        found += faults_of_resumption(stage, folder, earlier)
    where = f"{stage.story.name}: {fault.name}, call {at}, {call} of {pathlib.Path(path).name}{', over an earlier result' if earlier else ''}"
    return [f"{where}: {text}" for text in found]


def faults_of_resumption(stage, folder, earlier):
    """After the fault has gone, the same command goes on and makes the whole; what it did not make, it replaces if told to."""
    command = [*stage.command(earlier), *(["--resume"] if "--resume" not in stage.story.command else [])]
    end = run(command, folder)
    if end.status != 0:
        return [f"cannot be resumed: {end.err!r}"]
    after = contents(folder)
    return [f"{name} is not right once resumed" for name in stage.story.makes if name not in after or not stage.is_whole(name, after[name])]


def count_calls(stage, fault, earlier):
    """The calls of a story that a fault may concern."""
    folder = stage.copy("counted", earlier)
    log = stage.root / "log"
    log.unlink(missing_ok=True)
    environment = {
        "LD_PRELOAD": library(),
        "FAULTY_FOLDER": str(folder),
        "FAULTY_CALLS": ",".join(fault.calls) + ",",
        "FAULTY_AT": "0",
        "FAULTY_LOG": str(log),
    }
    end = run(stage.command(earlier), folder, environment)
    if end.status != 0:
        raise SystemExit(f"{stage.story.name}: status {end.status} where calls were only counted: {end.err}")
    return end.calls


def limit_files(size):
    def limit():
        resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))

    return limit


@contextlib.contextmanager
def stages(stories):
    """A stage for each story, made when it is asked for."""
    with tempfile.TemporaryDirectory(prefix="sarsim-faults-") as root:
        def make(story):
            folder = pathlib.Path(root) / story.name
            folder.mkdir()
            return Stage(story, folder)

        yield (make(story) for story in stories)


def end_process(process):
    if process.poll() is None:
        process.send_signal(signal.SIGKILL)
    process.communicate()
