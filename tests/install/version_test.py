"""Where the version comes from: tags, archives, or the number that the tree carries.

usage: version_test.py CMAKE
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

from installing import SOURCE, expect, run, skip

NEEDED = ("cmake/SarsimVersion.cmake", "cmake/WriteBuild.cmake", "cmake/archive-version.txt", ".gitattributes")
ASK = """
include({source}/cmake/SarsimVersion.cmake)
sarsim_find_version({folder} V)
foreach(name NUMBER TAG AHEAD COMMIT CHANGED PACKAGE TEXT)
  message("${{name}}=${{V_${{name}}}}")
endforeach()
"""


class Sources:
    """A small tree with its own history."""

    def __init__(self, cmake, folder):
        self.cmake, self.folder = cmake, folder
        for name in NEEDED:
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(SOURCE / name, folder / name)
        self.write("CITATION.cff", "cff-version: 1.2.0\nversion: 0.3.0\n")

    def write(self, name, text):
        (self.folder / name).write_text(text)

    def git(self, *words):
        names = {f"GIT_{who}_{what}": "test@localhost" for who in ("AUTHOR", "COMMITTER") for what in ("NAME", "EMAIL")}
        environment = os.environ | names | {"GIT_CONFIG_GLOBAL": os.devnull, "GIT_CONFIG_SYSTEM": os.devnull}
        done = run("git", "-C", self.folder, *words, env=environment)
        expect(done.returncode == 0, "git failed", done)
        return done.stdout.strip()

    def commit(self, name, text):
        self.write(name, text)
        self.git("add", "--all")
        self.git("commit", "--quiet", "--message", name)
        return self.git("rev-parse", "--short=12", "HEAD")

    def begin(self):
        self.git("init", "--quiet")
        return self.commit("first", "1")


def version_of(cmake, folder):
    with tempfile.NamedTemporaryFile("w", suffix=".cmake") as script:
        script.write(ASK.format(source=SOURCE, folder=folder))
        script.flush()
        told = run(cmake, "-P", script.name)
    expect(told.returncode == 0, "the version cannot be found", told)
    return dict(line.split("=", 1) for line in told.stderr.splitlines() if "=" in line)


def holds(version, **expected):
    wrong = {name: version[name] for name in expected if version[name] != expected[name]}
    expect(not wrong, f"expected {expected}, found {wrong}")


def without_git_it_is_the_number_of_the_tree(cmake, folder):
    Sources(cmake, folder)
    holds(version_of(cmake, folder), NUMBER="0.3.0", COMMIT="", PACKAGE="0.3.0", TEXT="of unknown commit")


def before_the_first_tag_the_commit_is_known(cmake, folder):
    commit = Sources(cmake, folder).begin()
    text = f"commit {commit}, before the first release"
    holds(version_of(cmake, folder), NUMBER="0.3.0", PACKAGE=f"0.3.0~1.g{commit}", TEXT=text)


def a_tag_is_the_version(cmake, folder):
    sources = Sources(cmake, folder)
    sources.begin()
    for tag in ("v0.4.0", "v12.0.7"):
        sources.commit(f"for {tag}", "")
        sources.git("tag", "--annotate", tag, "--message", tag)
        holds(version_of(cmake, folder), NUMBER=tag[1:], TAG=tag, AHEAD="0", PACKAGE=tag[1:], TEXT="")


def later_commits_count_from_the_tag(cmake, folder):
    sources = Sources(cmake, folder)
    sources.begin()
    sources.git("tag", "v0.4.0")
    sources.commit("a", "")
    commit = sources.commit("b", "")
    text = f"commit {commit}, 2 after v0.4.0"
    holds(version_of(cmake, folder), NUMBER="0.4.0", AHEAD="2", PACKAGE=f"0.4.0+2.g{commit}", TEXT=text)


def other_tags_are_no_versions(cmake, folder):
    sources = Sources(cmake, folder)
    sources.begin()
    for tag in ("v1", "v1.2", "v9.9.9-rc1", "release-3.0.0"):
        sources.git("tag", tag)
    holds(version_of(cmake, folder), NUMBER="0.3.0", TAG="")


def changed_files_are_told(cmake, folder):
    sources = Sources(cmake, folder)
    sources.begin()
    sources.git("tag", "v0.4.0")
    sources.write("new file", "")
    holds(version_of(cmake, folder), CHANGED="FALSE", TEXT="")
    sources.write("first", "2")
    holds(version_of(cmake, folder), CHANGED="TRUE", PACKAGE="0.4.0+changed", TEXT="v0.4.0, with changes")


def archives_know_where_they_come_from(cmake, folder):
    sources = Sources(cmake, folder)
    first = sources.begin()

    def unpacked(name):
        # Inside the checkout, whose history is not that of the archive.
        target = folder / name
        target.mkdir()
        packed = subprocess.run(["git", "-C", folder, "archive", "HEAD"], check=True, capture_output=True).stdout
        subprocess.run(["tar", "-x", "-C", target], input=packed, check=True)
        return version_of(cmake, target)

    holds(unpacked("untagged"), NUMBER="0.3.0", COMMIT=first, PACKAGE=f"0.3.0~0.g{first}")
    sources.git("tag", "v0.4.0")
    holds(unpacked("tagged"), NUMBER="0.4.0", TAG="v0.4.0", PACKAGE="0.4.0", TEXT="")
    later = sources.commit("later", "")
    holds(unpacked("later_one"), NUMBER="0.4.0", COMMIT=later, PACKAGE=f"0.4.0+1.g{later}")


def what_was_built_is_written_only_where_it_changed(cmake, folder):
    sources = Sources(cmake, folder)
    sources.begin()
    sources.git("tag", "v0.4.0")
    (folder / "template").write_text("@SARSIM_TEXT@|@TYPE@")
    out = folder / "out"

    def write(number="0.4.0"):
        words = {"SOURCE": folder, "NUMBER": number, "STAMP": folder / "stamp", "TEMPLATE": folder / "template"}
        words |= {"OUT": out, "TYPE": "Debug"}
        return run(cmake, *(f"-D{name}={word}" for name, word in words.items()), "-P", SOURCE / NEEDED[1])

    expect(write().returncode == 0 and out.read_text().strip() == "|Debug", "a release is not told")
    os.utime(out, (0, 0))
    expect(write().returncode == 0 and out.stat().st_mtime == 0, "it was written although nothing changed")
    commit = sources.commit("later", "")
    expect(write().returncode == 0 and out.read_text().strip() == f"commit {commit}, 1 after v0.4.0|Debug", "old commit")
    expect(not (folder / "stamp").exists(), "configured again although the number is the same")
    told = write("0.3.0")
    expect(told.returncode != 0 and (folder / "stamp").exists(), "another number goes unnoticed", told)


def a_release_states_one_number(cmake, _folder):
    """At a tag, what the tree says of itself is the number of the tag."""
    found = version_of(cmake, SOURCE)
    if not found["TAG"] or found["AHEAD"] != "0":
        return
    citation = re.search(r"^version: (.*)$", (SOURCE / "CITATION.cff").read_text(), re.MULTILINE).group(1)
    expect(citation == found["NUMBER"], f"CITATION.cff says {citation}, the tag {found['TAG']}")
    heading = re.search(r"^## ([0-9]\S*)", (SOURCE / "CHANGELOG.md").read_text(), re.MULTILINE)
    expect(heading and heading.group(1) == found["NUMBER"], f"CHANGELOG.md does not begin with {found['NUMBER']}")


def main():
    (cmake,) = sys.argv[1:]
    if shutil.which("git") is None:
        skip("there is no git")
    for case in (
        without_git_it_is_the_number_of_the_tree,
        before_the_first_tag_the_commit_is_known,
        a_tag_is_the_version,
        later_commits_count_from_the_tag,
        other_tags_are_no_versions,
        changed_files_are_told,
        archives_know_where_they_come_from,
        what_was_built_is_written_only_where_it_changed,
        a_release_states_one_number,
    ):
        print(case.__name__.replace("_", " "))
        with tempfile.TemporaryDirectory() as name:
            case(cmake, pathlib.Path(name))


main()
