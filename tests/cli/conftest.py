"""The sweep command is tested on the grids of the sweep's own tests."""

from tests.sweep.conftest import grid_file, in_process

__all__ = ["grid_file", "in_process"]
