"""The groups of cases, each a test of its own."""

import interruptions
import numeric_fields
import scene_cases
import script_cases
import world_cases
from harness import try_case

GROUPS = {"sound": lambda: [numeric_fields.sound_case()]}
for command in numeric_fields.COMMANDS:
    GROUPS[f"numbers_{command[1:].lower()}"] = lambda command=command: numeric_fields.cases(command)
for module in (script_cases, scene_cases, world_cases, interruptions):
    GROUPS.update(module.GROUPS)


def attempt(case):
    """What a user saw of a case, and what is wrong with it."""
    return interruptions.try_interruption(case) if isinstance(case, interruptions.Interruption) else try_case(case)
