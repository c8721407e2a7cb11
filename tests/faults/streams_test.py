#!/usr/bin/env python3
"""With standard streams closed, commands write the same files, and nothing that they print lands in them."""

import concurrent.futures
import os
import pathlib
import subprocess
import sys
import tempfile

import stories
from faults import TIME_LIMIT_S, contents, program, steady

CLOSED = ((), (2,), (0, 1, 2))


def written(story, folder, closed):
    """What a story leaves in a folder of its own, its command started with these descriptors closed."""
    folder.mkdir(parents=True)
    for name, content in story.files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content.encode() if isinstance(content, str) else content)
    quiet = {"stdin": subprocess.DEVNULL, "stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL, "timeout": TIME_LIMIT_S}
    for command in story.before:
        subprocess.run([program(), *command], cwd=folder, check=True, **quiet)
    # Python itself needs its streams until the last moment.
    script = "exec " + " ".join("<&-" if number == 0 else f"{number}>&-" for number in closed) + '; exec "$@"'
    subprocess.run(["sh", "-c", script, "sh", program(), *story.command], cwd=folder, **quiet)
    # Journals hold when and by whom they were written.
    return {name: steady(name, content) for name, content in contents(folder).items() if not name.endswith(".journal")}


def main():
    wrong = []
    compared = 0
    # Together, because some of them mostly wait for the disk.
    pool = concurrent.futures.ThreadPoolExecutor(len(CLOSED))
    with tempfile.TemporaryDirectory(prefix="sarsim-streams-") as root, pool:
        for story in stories.all_stories().values():
            if story.slow or not story.same:
                continue
            folders = [pathlib.Path(root, story.name + "-".join(map(str, closed))) for closed in CLOSED]
            found = dict(zip(CLOSED, pool.map(written, [story] * len(CLOSED), folders, CLOSED)))
            missing = [name for name in story.makes if name not in found[()]]
            if missing:
                wrong.append(f"{story.name} does not make {', '.join(missing)}")
            for closed in CLOSED[1:]:
                names = sorted(set(found[()]) | set(found[closed]))
                differ = [name for name in names if found[()].get(name) != found[closed].get(name)]
                compared += len(names)
                if differ:
                    wrong.append(f"{story.name}, {closed} closed: {', '.join(differ)}")
    print("\n".join(wrong) or f"{compared} files are the same with streams closed")
    sys.exit(bool(wrong) or compared < 100)


main()
