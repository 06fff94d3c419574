"""Contact pressure along both axes through a contact's centre, at the nodes of a mesh and by Hertz.

Where the contact is symmetric a quarter of it is meshed, and positions run from the centre outwards. Where one
shoulder cuts it off a half is meshed, and transverse positions run from one side to the other.
"""

from dataclasses import dataclass
from typing import Annotated, Literal

import numpy as np
from annotated_types import MinLen

from analytic.rows import require_one_length
from analytic.scene import Array
from fembearing.fem.measure import Quantities
from fembearing.fem.solution import MeshSolution

Axis = Literal["rolling", "transverse"]
AXES: tuple[Axis, ...] = ("rolling", "transverse")
MOST = 60  # largest number of positions on an axis
BEYOND = 1.2  # semi-axes: farther out there is no contact
ON_AXIS = 1e-9  # share of the mesh's extent: round-off


@dataclass(frozen=True, kw_only=True)
class PressureProfile:
    """Pressure along one axis."""

    position: Annotated[tuple[float, ...], MinLen(1)]  # m from the contact's centre, ascending
    pressure: tuple[float, ...]  # Pa

    def __post_init__(self) -> None:
        """Raises ValueError for lists of different lengths."""
        require_one_length(self.position, self.pressure)


@dataclass(frozen=True, kw_only=True)
class BothProfiles:
    """The pressure along one axis at the nodes of the finest mesh, and by Hertz."""

    fe: PressureProfile
    hertz: PressureProfile


@dataclass(frozen=True, kw_only=True)
class Profiles:
    """The pressure along both axes through the centre."""

    rolling: BothProfiles
    transverse: BothProfiles


def nodal_profile(mesh: MeshSolution, axis: Axis) -> PressureProfile:
    """Nodal values on an axis as solved. They scatter by some tenths of a per cent; peak pressure is a fit to many.

    More than `MOST` nodes are thinned evenly, keeping both ends and the centre. A node without force has pressure 0.
    """
    along, across = (mesh.x, mesh.y) if axis == "rolling" else (mesh.y, mesh.x)
    semi_axis = mesh.semi_axes[AXES.index(axis)]
    on_axis = np.abs(across) <= ON_AXIS * np.abs(across).max()
    nodes = np.flatnonzero(on_axis & (np.abs(along) <= BEYOND * semi_axis))
    nodes = nodes[np.argsort(along[nodes])]
    centre = int(np.argmin(np.abs(along[nodes])))
    step = -(-nodes.size // (MOST - 2))  # both ends are added
    chosen = np.unique([0, *range(centre % step, nodes.size, step), nodes.size - 1])
    nodes = nodes[chosen]
    return _profile(along[nodes], np.where(mesh.force[nodes] > 0, mesh.pressure[nodes], 0.0))


def hertz_profile(hertz: Quantities, axis: Axis) -> PressureProfile:
    """p0 sqrt(1 - (s/a)^2) from the centre to the edge, with denser positions near the edge."""
    angle = np.linspace(0, np.pi / 2, MOST)
    semi_axis = hertz.semi_axis_rolling if axis == "rolling" else hertz.semi_axis_transverse
    pressure = hertz.peak_pressure * np.cos(angle)
    pressure[-1] = 0.0  # without round-off
    return _profile(semi_axis * np.sin(angle), pressure)


def profiles_of(mesh: MeshSolution, hertz: Quantities) -> Profiles:
    """Both axes, by finite elements and by Hertz."""
    rolling, transverse = (
        BothProfiles(fe=nodal_profile(mesh, axis), hertz=hertz_profile(hertz, axis)) for axis in AXES
    )
    return Profiles(rolling=rolling, transverse=transverse)


def _profile(position: Array, pressure: Array) -> PressureProfile:
    return PressureProfile(position=tuple(position.tolist()), pressure=tuple(pressure.tolist()))
