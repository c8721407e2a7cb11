"""Goes on with the Python that SARSIM_TEST_PYTHON names where the present one lacks packages that a test can use."""

import importlib.util
import os
import sys


def prefer(*modules):
    """Returns where all are there, or no other Python is named."""
    other = os.environ.pop("SARSIM_TEST_PYTHON", "")
    if other and any(importlib.util.find_spec(name) is None for name in modules):
        os.execv(other, [other, "-B", *sys.argv])
