#!/usr/bin/env python3
"""The files of examples/engines as far as they can be tried without their engines: they parse, their options exist, and the
commands that they give to the machines of a cluster make the bytes of a single run when they are given here, one by one.
The guide shows and names them. The commands that a sweep prints are carried out by xargs and make what the sweep makes.
"""

import ast
import json
import os
import pathlib
import re
import shlex
import tempfile

from engines_support import RECIPES, SOURCE, bin_folder, expect, expect_done, expect_same, program, run, write_scene

UNTRIED = ("k8s-indexed-job.yaml", "aws-batch.sh")
TRIED = ("slurm.sh", "Snakefile", "dask_sweep.py", "ray_sweep.py")
GUIDE = SOURCE / "docs" / "guide" / "many-machines.md"


def text_of(name):
    return (RECIPES / name).read_text()


def every_file_is_known():
    found = sorted(path.name for path in RECIPES.iterdir())
    expect(found == sorted(UNTRIED + TRIED), f"examples/engines: {found}")
    guide = GUIDE.read_text()
    for name in found:
        expect(f"`{name}`" in guide or f"[`{name}`]" in guide, f"{GUIDE.name} does not name {name}")
        expect(("NOT TRIED BY US" in text_of(name)) == (name in UNTRIED), f"{name}: tried or not?")
    # Word for word, but for the comment that says how to start it.
    expect(re.sub(r"(?m)^# .*\n", "", text_of("slurm.sh")) in guide, f"{GUIDE.name} shows another slurm.sh")


def every_file_parses():
    for name in ("slurm.sh", "aws-batch.sh"):
        expect_done(run(["bash", "-n", RECIPES / name]))
    for name in ("dask_sweep.py", "ray_sweep.py"):
        ast.parse(text_of(name), name)
    for name in ("dask_sweep.py", "ray_sweep.py"):
        expect("BAD_INPUT, TRY_AGAIN = 2, 75" in text_of(name), f"{name}: other exit statuses")


def every_option_exists():
    known = set()
    for command in ("run", "sweep"):
        known |= set(re.findall(r"--[a-z][a-z-]*", expect_done(run([program(), command, "--help"])).stdout))
    for name in UNTRIED + TRIED:
        commands = re.findall(r'sarsim"?,? (?:run|sweep|\*command)(?:[^\\\n]|\\\n)*', text_of(name))
        options = set(re.findall(r"--[a-z][a-z-]*", " ".join(commands)))
        expect({"--part", "--resume"} <= options, f"{name}: only {options} were found")
        expect(options <= known | {"--parts", "--scheduler"}, f"{name}: sarsim has no {options - known}")


def aws_job():
    text = text_of("aws-batch.sh")
    job = json.loads(text[text.index("<<'JSON'\n") + 9 : text.index("\nJSON\n")])
    size = int(re.search(r"--array-properties size=(\d+)", text)[1])
    statuses = {rule.get("onExitCode"): rule["action"] for rule in job["retryStrategy"]["evaluateOnExit"]}
    expect(statuses["2"] == "EXIT", "bad input is tried again")
    return size, "AWS_BATCH_JOB_ARRAY_INDEX", job["containerProperties"]["command"]


def kubernetes_job():
    """Read with what the standard library has: a list of words below "command:", one a line."""
    text = text_of("k8s-indexed-job.yaml")
    try:
        import yaml

        spec = yaml.safe_load(text)["spec"]
        container = spec["template"]["spec"]["containers"][0]
        rules = {code: rule["action"] for rule in spec["podFailurePolicy"]["rules"]
                 for code in rule.get("onExitCodes", {}).get("values", [])}
        expect(rules == {2: "FailJob", 75: "Ignore"}, f"exit statuses: {rules}")
        return spec["completions"], "JOB_COMPLETION_INDEX", container["command"]
    except ImportError:
        print("without python3-yaml the file is not parsed")
    block = re.search(r"command:\n((?: +- .*\n)+)", text)[1]
    words = [line.strip()[2:] for line in block.splitlines()]
    return int(re.search(r"completions: (\d+)", text)[1]), "JOB_COMPLETION_INDEX", words


def commands_of_machines_make_the_recording(folder, environment):
    for size, variable, words in (kubernetes_job(), aws_job()):
        data = folder / variable
        data.mkdir()
        write_scene(data, 400)
        here = [word.replace("/data/", f"{data}/") for word in words]
        for index in range(size):
            expect_done(run(here, env=environment | {variable: str(index)}, cwd=folder))
        expect_done(run([program(), "run", "scene.toml", "--out", "whole"], cwd=data))
        expect_same(data / "whole" / "sim.bin", data / "run1" / "sim.bin")


# As much of Ray as the recipe uses, in one process.
RAY = """
def init(address, num_cpus):
    assert address is None and num_cpus is None

class Task:
    def __init__(self, function):
        self.function = function
    def options(self, num_cpus):
        assert num_cpus == 1
        return self
    def remote(self, *arguments):
        return lambda: self.function(*arguments)

def remote(**options):
    assert options["max_retries"] > 0 and options["retry_exceptions"]
    return Task

def wait(todo):
    return todo[:1], todo[1:]

def get(task):
    return task()
"""


def ray_script_makes_the_recording(folder, environment):
    (folder / "ray.py").write_text(RAY)
    words = ["python3", "-B", RECIPES / "ray_sweep.py", "--parts", "3", "run", "scene.toml", "--out", "ray"]
    environment = environment | {"PYTHONPATH": str(folder)}
    expect_done(run(words, env=environment, cwd=folder))
    expect_same(folder / "whole" / "sim.bin", folder / "ray" / "sim.bin")
    bad = run([*words, "--seed", "no"], env=environment, cwd=folder)
    expect(bad.returncode == 2, f"bad input: {bad.returncode}")


def commands_of_a_sweep_make_its_files(folder, environment):
    sweep = [program(), "sweep", "scene.toml", "--set", "seed=1..3", "--set", "Target1.rcs=1,2.5m2", "--out", "it's all"]
    listed = expect_done(run([*sweep, "--resume", "--dry-run", "--commands"], cwd=folder)).stdout
    expect(len(listed.splitlines()) == 6 and all(line.endswith(" --resume") for line in listed.splitlines()), listed)
    guide = (SOURCE / "docs" / "guide" / "sweeps.md").read_text()
    xargs = re.search(r"xargs .*(?= < commands.txt)", guide)[0]
    for _ in range(2):  # Each command may be given again.
        expect_done(run(shlex.split(xargs), input=listed, env=environment, cwd=folder))
    made = folder / "it's all"
    made.rename(folder / "by-xargs")
    expect_done(run(sweep, cwd=folder))
    for path in made.glob("sim_*"):
        expect_same(path, folder / "by-xargs" / path.name)
    expect(len(list(made.glob("sim_*"))) == 6, "not six files")


def main():
    every_file_is_known()
    every_file_parses()
    every_option_exists()
    with tempfile.TemporaryDirectory(prefix="sarsim-recipes-") as name:
        folder = pathlib.Path(name)
        write_scene(folder, 300)
        environment = dict(os.environ, PATH=f"{bin_folder(folder)}:{os.environ['PATH']}")
        expect_done(run([program(), "run", "scene.toml", "--out", "whole"], cwd=folder))
        commands_of_machines_make_the_recording(folder, environment)
        ray_script_makes_the_recording(folder, environment)
        commands_of_a_sweep_make_its_files(folder, environment)
    print("recipes: they parse, their options exist, their commands make the bytes of a single run")


if __name__ == "__main__":
    main()
