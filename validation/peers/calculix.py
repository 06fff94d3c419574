"""Peer: CalculiX, 20-node hexahedra with reduced integration (C3D20R), penalty contact between surfaces.

The refinement is the level of our mesh recipe. By symmetry, each of two equal half spaces is pressed against a rigid
paraboloid with half the gap. Here the paraboloid is one layer of cells that moves as one body under the load. Lengths
are written in mm, stresses in MPa.
"""

import os
import shutil
import subprocess
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from fembearing.fem.farfield import pressed_ellipse
from validation.peers.ours import Quarter, idealised_contact, quarter
from validation.peers.peer import peak_pressure, semi_axis

# Contact acts along the normal of the paraboloid, which is inclined by 2 % at the edge; Hertz neglects this. Flattening
# the paraboloid by this factor and stiffening the steel by its inverse leaves pressure and ellipse unchanged.
FLATTENING = 1e-3
PENALTY = 1e4  # times the modulus over the minor semi-axis; 1e3 changes the second digit of the finest errors
MM = 1e3  # in a metre
PROGRAM = "ccx"

if shutil.which(PROGRAM) is None:
    raise ImportError(f"{PROGRAM} is not installed")


def solve(case: dict[str, Any], level: int) -> dict[str, Any]:
    block = quarter(case, level)
    corners = block.cells[:, :4]  # of the lowest face, S1, which alone is on the surface
    supports = np.flatnonzero(block.top[corners].all(axis=1) & block.touching[corners].any(axis=1))
    anticlockwise = block.cells[supports][:, [0, 3, 2, 1, 11, 10, 9, 8]]  # as seen from above
    used, faces = np.unique(anticlockwise, return_inverse=True)
    faces = faces.reshape(-1, 8)
    x, y = block.position[used, :2].T
    modulus = case["youngs_modulus"] / (1 - case["poisson_ratio"] ** 2)
    overlap = 0.6 * case["load"] / (modulus * np.sqrt(np.prod(case["semi_axes"])))  # m, to start in contact
    height = (case["curvature_x"] * x**2 + case["curvature_y"] * y**2) / 4 - overlap
    held = np.pad(block.position[:, :2] < 1e-9 * block.position.max(), ((0, 0), (0, 1))) | block.far[:, None]
    paraboloid = np.column_stack([x, y, height])
    with tempfile.TemporaryDirectory() as folder:
        job = Path(folder) / "job"
        lines = deck(case, block, held=held, supports=supports, faces=faces, paraboloid=paraboloid)
        job.with_suffix(".inp").write_text("\n".join(lines) + "\n", "ascii")
        environment = {"OMP_NUM_THREADS": str(os.cpu_count()), **os.environ}
        done = subprocess.run([PROGRAM, "job"], cwd=folder, env=environment, capture_output=True, text=True)
        printed = job.with_suffix(".dat").read_text("ascii") if job.with_suffix(".dat").exists() else ""
    if done.returncode or "forces" not in printed:
        raise RuntimeError(f"{PROGRAM} ended with status {done.returncode}: {(done.stdout + done.stderr)[-500:]}")
    force = table(printed, "forces")[:, 3]  # N, nodal forces: integrals of pressure times shape function
    axes = semi_axis(x, force), semi_axis(y, force)
    points_x, points_y, area, pressure = at_gauss_points(x, y, faces, force)
    sunk = table(printed, "displacements")[0, 3] / (MM * FLATTENING)
    return {
        "semi_axis_x": axes[0],
        "semi_axis_y": axes[1],
        "peak_pressure": peak_pressure(points_x, points_y, pressure, area, semi_axes=axes),
        "approach": float(2 * (overlap - sunk)),
        "unknowns": int((~held).sum()),
    }


def deck(
    case: dict[str, Any],
    block: Quarter,
    *,
    held: NDArray[np.bool_],
    supports: NDArray[np.intp],
    faces: NDArray[np.intp],
    paraboloid: NDArray[np.float64],
) -> Iterator[str]:
    """The lines of the input file.

    held : components of the nodes of the block, (nodes, 3);  supports : cells of the block that may touch
    faces : their 8 nodes on the paraboloid, (supports, 8)
    """
    minor = min(case["semi_axes"]) * MM
    modulus = case["youngs_modulus"] / 1e6 / FLATTENING
    lower = paraboloid * [MM, MM, MM * FLATTENING]
    rigid, corners = len(lower), np.unique(faces[:, :4])
    upper, middle = lower + np.array([0, 0, minor]), lower[corners] + np.array([0, 0, minor / 2])
    nodes = np.vstack([block.position * MM, lower, upper, middle])
    first = len(block.position) + 1  # node of the paraboloid that carries the load; the others follow it
    below, above = faces + first, faces + first + rigid
    between = np.searchsorted(corners, faces[:, :4]) + first + 2 * rigid
    layer = np.hstack([below[:, :4], above[:, :4], below[:, 4:], above[:, 4:], between])
    yield "*NODE"
    yield from (f"{number},{x:.12g},{y:.12g},{z:.12g}" for number, (x, y, z) in enumerate(nodes, start=1))
    above_block = len(block.cells) + 1
    for name, start, cells in (("C3D20R,ELSET=BLOCK", 1, block.cells + 1), ("C3D20,ELSET=RIGID", above_block, layer)):
        yield f"*ELEMENT,TYPE={name}"
        for number, cell in enumerate(cells.astype(str), start):
            yield f"{number},{','.join(cell[:10])},\n{','.join(cell[10:])}"
    yield "*SURFACE,NAME=BELOW"
    yield from (f"{cell + 1},S1" for cell in supports)
    yield "*SURFACE,NAME=ABOVE\nRIGID,S1"
    yield f"*NSET,NSET=ALLRIGID,GENERATE\n{first},{len(nodes)}"
    yield f"*NSET,NSET=PARABOLOID,GENERATE\n{first},{first + rigid - 1}"
    yield "*EQUATION"
    yield from (f"2\n{node},3,1.,{first},3,-1." for node in range(first + 1, len(nodes) + 1))
    yield f"*MATERIAL,NAME=STEEL\n*ELASTIC\n{modulus:.10g},{case['poisson_ratio']}"
    yield "*SOLID SECTION,ELSET=BLOCK,MATERIAL=STEEL\n*SOLID SECTION,ELSET=RIGID,MATERIAL=STEEL"
    yield "*SURFACE INTERACTION,NAME=TOUCH\n*SURFACE BEHAVIOR,PRESSURE-OVERCLOSURE=LINEAR"
    yield f"{PENALTY * modulus / minor:.10g},1e-6"
    yield "*CONTACT PAIR,INTERACTION=TOUCH,TYPE=SURFACE TO SURFACE\nBELOW,ABOVE"
    yield "*BOUNDARY\nALLRIGID,1,2\n*STEP,INC=50\n*STATIC\n1.,1.\n*BOUNDARY"
    x, y, z = block.position[block.far].T
    steel = idealised_contact(case).race_material
    unit = pressed_ellipse(x, y, -z, semi_axes=tuple(case["semi_axes"]), material=steel)
    moved = np.zeros_like(block.position)  # zero also where symmetry holds a node
    moved[block.far] = (unit * [[1], [1], [-1]]).T * case["load"] * MM * FLATTENING  # the third points into the body
    yield from (f"{node + 1},{axis + 1},{axis + 1},{moved[node, axis]:.12g}" for node, axis in np.argwhere(held))
    yield f"*CLOAD\n{first},3,{-case['load'] / 4:.12g}"
    yield "*NODE PRINT,NSET=PARABOLOID\nU,RF\n*END STEP"


def table(printed: str, head: str) -> NDArray[np.float64]:
    """The last table of a .dat file whose title starts with `head`."""
    body = printed[printed.rindex(f" {head} (") :].split("\n\n")[1]
    return np.array([[float(word) for word in line.split()] for line in body.splitlines()])


def at_gauss_points(
    x: NDArray[np.float64], y: NDArray[np.float64], faces: NDArray[np.intp], force: NDArray[np.float64]
) -> tuple[NDArray[np.float64], ...]:
    """x, y, area and pressure at 2 by 2 Gauss points of each face, of the field whose integrals are the nodal forces.

    Away from these points a field on 8-node faces oscillates: at its nodes the peak pressure is 1 to 8 % too high.
    """
    shape, area = on_faces(x, y, faces, 3)
    mass = np.zeros((x.size, x.size))
    np.add.at(mass, (faces[:, :, None], faces[:, None, :]), np.einsum("fq,qi,qj->fij", area, shape, shape))
    pressure = np.linalg.solve(mass, -force)  # the printed force holds the paraboloid down, the surface pushes it up
    shape, area = on_faces(x, y, faces, 2)
    at_x, at_y, at_pressure = ((nodal[faces] @ shape.T).ravel() for nodal in (x, y, pressure))
    return at_x, at_y, area.ravel(), at_pressure


def on_faces(
    x: NDArray[np.float64], y: NDArray[np.float64], faces: NDArray[np.intp], count: int
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """At count by count Gauss points the shape functions (points, 8) of 8-node faces and the areas (faces, points)."""
    places, weights = np.polynomial.legendre.leggauss(count)
    s, t = (each.ravel() for each in np.meshgrid(places, places))
    corner_s, corner_t = np.array([[-1, 1, 1, -1, 0, 1, 0, -1], [-1, -1, 1, 1, -1, 0, 1, 0]])
    nodal = np.linalg.inv(terms(corner_s, corner_t))  # coefficients of the terms of each shape function
    none = np.zeros_like(s)
    by_s = np.column_stack([none, none + 1, none, 2 * s, t, none, 2 * s * t, t * t]) @ nodal
    by_t = np.column_stack([none, none, none + 1, none, s, 2 * t, s * s, 2 * s * t]) @ nodal
    x, y = x[faces], y[faces]
    area = (x @ by_s.T) * (y @ by_t.T) - (x @ by_t.T) * (y @ by_s.T)
    return terms(s, t) @ nodal, area * np.outer(weights, weights).ravel()


def terms(s: NDArray[Any], t: NDArray[Any]) -> NDArray[Any]:
    """The terms (points, 8) of a polynomial that 8 nodes, corners and middles, determine."""
    return np.column_stack([np.ones_like(s), s, t, s * s, s * t, t * t, s * s * t, s * t * t])
