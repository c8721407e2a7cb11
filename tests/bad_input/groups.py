"""The groups of cases, each a test of its own."""

import numeric_fields
from harness import try_case

GROUPS = {"sound": lambda: [numeric_fields.sound_case()]}
for command in numeric_fields.COMMANDS:
    GROUPS[f"numbers_{command[1:].lower()}"] = lambda command=command: numeric_fields.cases(command)

attempt = try_case
