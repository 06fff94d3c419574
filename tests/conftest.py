"""Settings of the whole test run.

On the gate (CI is set) property tests draw the same examples every time, so that a red run is about the change
under test; everywhere else they explore, and a failure prints the blob that reproduces it.
"""

import os

from hypothesis import settings

if "PYTEST_XDIST_WORKER" in os.environ:  # before NumPy loads: the workers are the parallelism already
    os.environ.setdefault("OMP_NUM_THREADS", "1")

PROFILE = "gate" if os.environ.get("CI") else "explore"

# No deadline: the first call of a compiled kernel takes seconds, later ones microseconds.
settings.register_profile("explore", deadline=None, print_blob=True)
settings.register_profile("gate", deadline=None, print_blob=True, derandomize=True)
settings.load_profile(PROFILE)


def pytest_report_header() -> str:
    return f"hypothesis profile: {PROFILE}"
