#!/usr/bin/env python3
"""Gives sarsim bad inputs and expects it to refuse each properly.

    SARSIM_PROGRAM=build/dev/src/sarsim tests/bad_input/run_cases.py [-v] [GROUP...]     default: all groups
    tests/bad_input/run_cases.py --list

Proper is: the expected exit status within the time limit, one message that names the place where there is one and gives
a hint, nothing on standard output, and every file as it was before. Exit status: 0 all as expected, 1 not.
"""

import argparse
import concurrent.futures
import os
import sys

import groups
from harness import possible


def report(case, seen, found):
    print(f"FAILED {case.name}")
    for fault in found:
        print(f"    {fault}")
    for line in seen.err.splitlines()[:12]:
        print(f"    | {line[:200]}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("groups", nargs="*", metavar="GROUP")
    parser.add_argument("--list", action="store_true", help="names of the groups")
    parser.add_argument("-v", "--verbose", action="store_true", help="what every case shows")
    parser.add_argument("-k", metavar="TEXT", default="", help="only cases with this in their names")
    arguments = parser.parse_args()
    if arguments.list:
        print("\n".join(groups.GROUPS))
        return 0
    cases = [c for name in arguments.groups or groups.GROUPS for c in groups.GROUPS[name]() if arguments.k in c.name]
    skipped = [case for case in cases if not possible(case)]
    cases = [case for case in cases if possible(case)]
    failures = 0
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for case, (seen, found) in zip(cases, pool.map(groups.attempt, cases)):
            if found:
                failures += 1
                report(case, seen, found)
            elif arguments.verbose:
                print(f"ok {case.name}\n{seen.err.rstrip()}\n")
    for case in skipped:
        print(f"skipped {case.name}: this machine does not allow it")
    print(f"{len(cases)} cases, {failures} failed")
    return 1 if failures or not cases else 0


if __name__ == "__main__":
    sys.exit(main())
