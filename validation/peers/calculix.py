"""Peer: CalculiX, 20-node hexahedra with reduced integration (C3D20R), penalty contact between surfaces.

The refinement is the level of our mesh recipe. By symmetry, each of two equal half spaces is pressed against a rigid
paraboloid with half the gap. Here the paraboloid is one layer of cells that moves as one body under the load. Lengths
are written in mm, stresses in MPa.
"""

import os
import shutil
import subprocess
import tempfile
from collections.abc import Iterable, Iterator
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from validation.peers.idealised import Quarter, quarter
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
    chosen = block.contact_faces()
    used, faces = np.unique([nodes for _, _, nodes in chosen], return_inverse=True)
    faces = faces.reshape(-1, 8)
    x, y = block.position[used, :2].T
    modulus = case["youngs_modulus"] / (1 - case["poisson_ratio"] ** 2)
    overlap = 0.6 * case["load"] / (modulus * np.sqrt(np.prod(case["semi_axes"])))  # m, to start in contact
    height = (case["curvature_x"] * x**2 + case["curvature_y"] * y**2) / 4 - overlap
    with tempfile.TemporaryDirectory() as folder:
        job = Path(folder) / "job"
        supports = [(cell, face) for cell, face, _ in chosen]
        lines = deck(case, block, supports=supports, faces=faces, paraboloid=np.column_stack([x, y, height]))
        job.with_suffix(".inp").write_text("\n".join(lines) + "\n", "ascii")
        threads = os.environ.get("OMP_NUM_THREADS", str(os.cpu_count()))
        environment = os.environ | {"OMP_NUM_THREADS": threads}
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
        "unknowns": 3 * len(block.position) - sum(map(len, held(block))) - 3 * int(block.far.sum()),
    }


def deck(
    case: dict[str, Any],
    block: Quarter,
    *,
    supports: list[tuple[int, int]],
    faces: NDArray[np.intp],
    paraboloid: NDArray[np.float64],
) -> Iterator[str]:
    """The lines of the input file.

    supports : cells and faces of the block that may touch;  faces : their 8 nodes on the paraboloid
    """
    position, count = block.position, len(block.position)
    minor = min(case["semi_axes"]) * MM
    modulus = case["youngs_modulus"] / 1e6 / FLATTENING
    lower = paraboloid * [MM, MM, MM * FLATTENING]
    rigid, corners = len(lower), np.unique(faces[:, :4])
    upper, middle = lower + np.array([0, 0, minor]), lower[corners] + np.array([0, 0, minor / 2])
    yield "*NODE"
    for number, place in enumerate(np.vstack([position * MM, lower, upper, middle]), start=1):
        yield f"{number},{place[0]:.12g},{place[1]:.12g},{place[2]:.12g}"
    first = count + 1  # node of the paraboloid that carries the load; the others follow it
    last = count + 2 * rigid + corners.size
    yield "*ELEMENT,TYPE=C3D20R,ELSET=BLOCK"
    for number, cell in enumerate(block.cells, start=1):
        yield from rows([number, *(cell + 1)], 10)
    yield "*ELEMENT,TYPE=C3D20,ELSET=RIGID"
    for number, face in enumerate(faces, start=len(block.cells) + 1):
        turned = face[[0, 1, 2, 3, 4, 5, 6, 7]] if right_handed(lower[face[:4]]) else face[[0, 3, 2, 1, 7, 6, 5, 4]]
        below, above = turned + first, turned + first + rigid
        between = np.searchsorted(corners, turned[:4]) + first + 2 * rigid
        yield from rows([number, *below[:4], *above[:4], *below[4:], *above[4:], *between], 10)
    yield "*SURFACE,NAME=BELOW"
    yield from (f"{cell + 1},S{face + 1}" for cell, face in supports)
    yield "*SURFACE,NAME=ABOVE"
    yield from (f"{len(block.cells) + number},S1" for number in range(1, len(faces) + 1))
    plane_x, plane_y = held(block)
    sets = {
        "PLANEX": plane_x + 1,
        "PLANEY": plane_y + 1,
        "ALLRIGID": range(first, last + 1),
        "LEAD": [first],
        "PARABOLOID": range(first, first + rigid),
    }
    for name, nodes in sets.items():
        yield f"*NSET,NSET={name}"
        yield from rows(nodes, 12)
    yield "*EQUATION"
    for node in range(first + 1, last + 1):
        yield f"2\n{node},3,1.,{first},3,-1."
    yield f"*MATERIAL,NAME=STEEL\n*ELASTIC\n{modulus:.10g},{case['poisson_ratio']}"
    yield "*SOLID SECTION,ELSET=BLOCK,MATERIAL=STEEL\n*SOLID SECTION,ELSET=RIGID,MATERIAL=STEEL"
    yield "*SURFACE INTERACTION,NAME=TOUCH\n*SURFACE BEHAVIOR,PRESSURE-OVERCLOSURE=LINEAR"
    yield f"{PENALTY * modulus / minor:.10g},1e-6"
    yield "*CONTACT PAIR,INTERACTION=TOUCH,TYPE=SURFACE TO SURFACE\nBELOW,ABOVE"
    yield "*BOUNDARY\nPLANEX,1\nPLANEY,2\nALLRIGID,1,2\n*STEP,INC=50\n*STATIC\n1.,1.\n*BOUNDARY"
    for node in np.flatnonzero(block.far):
        for axis, moved in enumerate(block.displacement[node] * MM * FLATTENING, start=1):
            yield f"{node + 1},{axis},{axis},{moved:.12g}"
    yield f"*CLOAD\n{first},3,{-case['load'] / 4:.12g}"
    yield "*NODE PRINT,NSET=LEAD\nU\n*NODE PRINT,NSET=PARABOLOID\nRF\n*END STEP"


def held(block: Quarter) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Nodes that symmetry holds in x and in y, without those of the outer faces."""
    small = 1e-9 * block.position.max()
    x, y = (np.flatnonzero((block.position[:, axis] < small) & ~block.far) for axis in (0, 1))
    return x, y


def rows(numbers: Iterable[int], width: int) -> Iterator[str]:
    """Numbers in lines of at most `width`; all lines but the last end in a comma."""
    words = [str(number) for number in numbers]
    lines = [",".join(words[start : start + width]) for start in range(0, len(words), width)]
    yield ",\n".join(lines)


def right_handed(corners: NDArray[np.float64]) -> bool:
    """Whether four corners run anticlockwise as seen from above."""
    x, y = corners[:, 0], corners[:, 1]
    return float(np.sum(x * np.roll(y, -1) - y * np.roll(x, -1))) > 0


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
    mass = np.zeros((x.size, x.size))
    nodes = list(zip(*np.polynomial.legendre.leggauss(3), strict=True))
    for (s, weight_s), (t, weight_t) in product(nodes, repeat=2):
        shape, area = on_face(x, y, faces, s, t)
        for face, each in zip(faces, area, strict=True):
            mass[np.ix_(face, face)] += weight_s * weight_t * each * np.outer(shape, shape)
    pressure = np.linalg.solve(mass, -force)  # the printed force holds the paraboloid down, the surface pushes it up
    parts = []
    for s, t in product((-(3**-0.5), 3**-0.5), repeat=2):
        shape, area = on_face(x, y, faces, s, t)
        parts.append((x[faces] @ shape, y[faces] @ shape, area, pressure[faces] @ shape))
    return tuple(np.concatenate(part) for part in zip(*parts, strict=True))


def on_face(
    x: NDArray[np.float64], y: NDArray[np.float64], faces: NDArray[np.intp], s: float, t: float
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Shape functions (8,) of an 8-node face at (s, t) and the area per unit square (faces,) there."""
    S, T = np.array([-1, 1, 1, -1]), np.array([-1, -1, 1, 1])
    linear_s, linear_t = 1 + s * S, 1 + t * T
    shape = [*(linear_s * linear_t * (s * S + t * T - 1) / 4)]
    shape += [
        (1 - s * s) * (1 - t) / 2,
        (1 + s) * (1 - t * t) / 2,
        (1 - s * s) * (1 + t) / 2,
        (1 - s) * (1 - t * t) / 2,
    ]
    by_s = [*(S * linear_t * (2 * s * S + t * T) / 4), -s * (1 - t), (1 - t * t) / 2, -s * (1 + t), (t * t - 1) / 2]
    by_t = [*(T * linear_s * (s * S + 2 * t * T) / 4), (s * s - 1) / 2, -t * (1 + s), (1 - s * s) / 2, -t * (1 - s)]
    corner = x[faces] @ np.array(by_s), y[faces] @ np.array(by_t), x[faces] @ np.array(by_t), y[faces] @ np.array(by_s)
    return np.array(shape), np.abs(corner[0] * corner[1] - corner[2] * corner[3])
