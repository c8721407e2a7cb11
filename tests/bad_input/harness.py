"""Runs sarsim on a bad input in a folder of its own and says what is wrong with how it took it."""

import dataclasses
import functools
import os
import pathlib
import re
import shutil
import signal
import subprocess
import tempfile
import typing

TIME_LIMIT_S = 60.0  # Far more than any takes, for machines that are busy.
SCRIPT = "scene.scr"
PLACE = re.compile(r"^(?P<file>[^\s:]+):(?P<line>\d+):(?P<column>\d+): ")
PROBLEM = re.compile(r"^(?:\S+: )?(?:sarsim: )?(?P<severity>error|warning|note): ")


def program():
    """The program under test; the environment variable SARSIM_PROGRAM overrules what the build names."""
    name = os.environ.get("SARSIM_PROGRAM") or os.environ.get("SARSIM_BUILT_PROGRAM")
    if not name:
        raise SystemExit("set SARSIM_PROGRAM to the program to test")
    return os.path.abspath(name)


@dataclasses.dataclass
class Case:
    """One bad input and what the user is to see.

    Where the text of a file holds the mark `@`, that is where the message has to point, and the mark is not written.
    """

    name: str
    wrong: str  # What is wrong, for the table in the guide.
    files: dict[str, str | bytes] = dataclasses.field(default_factory=dict)
    command: typing.Sequence[str] = ("run", SCRIPT)
    status: int = 2
    message: typing.Sequence[str] = ()  # Regular expressions that standard error has to match.
    severity: str = "error"  # "" for a message that is no problem of a script, "warning" where the run goes on.
    hint: bool = True
    prepare: typing.Callable[[pathlib.Path], None] | None = None
    shell: str = ""  # Instead of the command; {sarsim} stands for the program.
    makes: typing.Sequence[str] = ()  # Files that a command that ends well leaves.
    anywhere: bool = False  # The message has a place, which is not marked.
    alone: bool = True  # Nothing else is said but the one error.
    user: int | None = None  # Run as this user where the tests run as root.
    mounts: bool = False  # Makes a small disk of its own.
    shown: str = ""  # The command line for the table, where it is not the default one.


@dataclasses.dataclass
class Seen:
    """What a user saw of a run."""

    status: int | None  # None: it did not end in time.
    out: str
    err: str
    changes: list[str]

    def paragraphs(self):
        """Standard error, one message with its hint each."""
        found = []
        for line in self.err.splitlines():
            if line.startswith("    ") and found:
                found[-1] += "\n" + line
            else:
                found.append(line)
        return found

    def problems(self, severity):
        return [p for p in self.paragraphs() if (m := PROBLEM.match(p)) and m["severity"] == severity]


def split_mark(text):
    """The text without its mark, and "line:column" of the mark."""
    if isinstance(text, bytes) or "@" not in text:
        return text, None
    before, _, after = text.partition("@")
    line = before.count("\n") + 1
    column = len(before.encode()) - (before.rfind("\n") + 1 if "\n" in before else 0) + 1
    return before + after, f"{line}:{column}"


def snapshot(folder):
    """Every entry below a folder with its content; folders that cannot be looked into are left out."""
    entries = {}
    for path in sorted(folder.rglob("*")):
        if path.is_symlink() or not path.is_file():
            entries[str(path.relative_to(folder))] = "folder" if path.is_dir() else "other"
        elif path.stat().st_size < 1 << 26:
            entries[str(path.relative_to(folder))] = path.read_bytes()
    return entries


def changes(before, after):
    names = sorted(set(before) | set(after))
    return [
        f"{name}: {'left behind' if name not in before else 'gone' if name not in after else 'changed'}"
        for name in names
        if before.get(name) != after.get(name)
    ]


def write_files(case, folder):
    """Writes a case's files; "file:line:column" of its mark."""
    marked = None
    for name, text in case.files.items():
        text, place = split_mark(text)
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        if place:
            marked = f"{name}:{place}"
    if case.prepare:
        case.prepare(folder)
    return marked


def start(case, folder, before=(), **streams):
    words = [*before, program(), *case.command]
    if case.shell:
        words = ["sh", "-c", case.shell.replace("{sarsim}", program())]
    user = case.user if os.geteuid() == 0 else None
    if user is not None:
        for path in [folder, *folder.rglob("*")]:
            os.chown(path, user, user)
    return subprocess.Popen(words, cwd=folder, stdin=subprocess.DEVNULL, user=user, start_new_session=True, **streams)


def run(case, folder):
    """What the user sees, and the place that the message has to name."""
    marked = write_files(case, folder)
    before = snapshot(folder)
    process = start(case, folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    try:
        out, err = process.communicate(timeout=TIME_LIMIT_S)
        status = process.returncode
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        out, err = process.communicate()
        status = None
    seen = Seen(status, out.decode(errors="replace"), err.decode(errors="replace"), changes(before, snapshot(folder)))
    return seen, marked


def faults_of_problem(case, seen, marked):
    """Exactly one problem, at its place, with a hint."""
    problems = seen.problems(case.severity)
    if len(problems) != 1:
        return [f"{len(problems)} {case.severity}s instead of one"]
    problem = problems[0]
    faults = []
    if case.severity == "error" and case.alone and len(seen.paragraphs()) != 1:
        faults.append("more is said than the one error")
    place = PLACE.match(problem)
    if marked and not problem.startswith(marked + ": "):
        faults.append(f"the message does not name {marked}")
    if case.anywhere and not place:
        faults.append("the message names no place")
    if case.hint and "\n    " not in problem and " expected " not in problem:
        faults.append("there is no hint")
    return faults


def faults(case, seen, marked):
    """What is wrong with how a case ended; empty for nothing."""
    if seen.status is None:
        return [f"did not end within {TIME_LIMIT_S:g} s"]
    found = []
    if seen.status != case.status:
        found.append(f"exit status {seen.status} instead of {case.status}")
    if case.severity:
        found += faults_of_problem(case, seen, marked)
    elif case.hint and seen.err and "\n    " not in seen.err and "Make room" not in seen.err:
        found.append("there is no hint")
    found += [f"the message does not say: {text}" for text in case.message if not re.search(text, seen.err, re.DOTALL)]
    if seen.out:
        found.append("something stands on standard output")
    if re.search(r"HDF5-DIAG|terminate called|Sanitizer|runtime error", seen.err):
        found.append("the insides of the program show")
    found += [change for change in seen.changes if change.removesuffix(": left behind") not in case.makes]
    found += [f"{name} was not made" for name in case.makes if f"{name}: left behind" not in seen.changes]
    return found


@functools.cache
def can_mount():
    """Whether a small disk can be made without being the superuser."""
    if not shutil.which("unshare"):
        return False
    command = ["unshare", "-rm", "sh", "-c", "mount -t tmpfs -o size=100k none /mnt"]
    return subprocess.run(command, capture_output=True, check=False).returncode == 0


@functools.cache
def can_run_as(user):
    """Whether the program can be started as this user, which only the superuser has to care about."""
    if os.geteuid() != 0:
        return True
    try:
        return subprocess.run([program(), "--version"], user=user, capture_output=True, check=False).returncode == 0
    except PermissionError:
        return False


def possible(case):
    """Whether a case can be tried on this machine."""
    return (not case.mounts or can_mount()) and (case.user is None or can_run_as(case.user))


def try_case(case):
    """What a user saw of a case, and what is wrong with it."""
    with tempfile.TemporaryDirectory(prefix="sarsim-bad-") as folder:
        seen, marked = run(case, pathlib.Path(folder))
        found = faults(case, seen, marked)
        if case.prepare:  # So that the folder can be removed whatever was forbidden.
            for path in pathlib.Path(folder).rglob("*"):
                if path.is_dir() and not path.is_symlink():
                    path.chmod(0o755)
        return seen, found
