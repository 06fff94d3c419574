"""Search for free balls with two steady states, at light load and high speed.

    python validation/adversary/steady_states.py [--scenes 100] [--seed 1000]

Draws the scenes of validation/adversary/radial.py with free balls under 0.1 to 5 N of thrust, at speeds where
centrifugal force is 1 to 100 times a ball's share of the thrust; most with a radial load, or the direction of gravity.
Prints how many have two states, by how much their torques differ, and each scene that has.
"""

import re
from typing import Annotated

import numpy as np
import typer

from analytic import friction_torque
from analytic.errors import FembearingError
from analytic.scenefile.read import parse_scene
from validation.adversary.radial import RADIAL_INPUTS, radial_scene

REPLACED = ("axial_load", "radial_load", "moment", "inner_speed", "down", "spin_rule")


def drawn_scene(seed: int) -> str:
    """A scene file."""
    rng = np.random.default_rng(seed)
    text = radial_scene(rng.random(RADIAL_INPUTS), tolerance=0.01)
    mass, count, diameter, bottom = (
        float(re.findall(rf'{key} = "?([0-9.e+-]+)', text)[0])
        for key in ("ball_mass", "ball_count", "ball_diameter", "bottom_radius")
    )
    axial, ratio = np.exp(rng.uniform(np.log(0.1), np.log(5.0))), np.exp(rng.uniform(0.0, np.log(100.0)))
    speed = 2 * np.sqrt(ratio * axial / count / (mass * (bottom + diameter / 2)))
    operation = [f'axial_load = "{axial:.6g} N"', f'inner_speed = "{speed:.6g} rad/s"']
    if rng.random() < 0.6:
        operation.append(f'radial_load = "{axial * np.exp(rng.uniform(np.log(0.05), np.log(20.0))):.6g} N"')
    if rng.random() < 0.6:
        operation.append(f"down = [{', '.join(f'{part:.4g}' for part in rng.uniform(-1, 1, 3))}]")
    lines = [line for line in text.splitlines() if not line.startswith(REPLACED)]
    place = lines.index("[operation]") + 1
    lines[place:place] = operation
    return "\n".join([*lines, 'spin_rule = "free"']) + "\n"


def main(
    scenes: Annotated[int, typer.Option(min=1, help="Scenes to draw.")] = 100,
    seed: Annotated[int, typer.Option(help="Of the first scene.")] = 1000,
) -> None:
    """Count the scenes with two steady states."""
    computed, apart = 0, []
    for each in range(seed, seed + scenes):
        try:
            found = friction_torque(parse_scene(drawn_scene(each), origin=f"seed {each}"))
        except FembearingError:
            continue
        computed += 1
        for warning in found.warnings:
            if torques := re.findall(r"resist ([0-9.e-]+) N mm or ([0-9.e-]+) N mm", warning):
                one, other = map(float, torques[0])
                apart.append(abs(other / one - 1))
                typer.echo(f"seed {each}, {100 * apart[-1]:.2g} % apart: {warning}")
    typer.echo(f"{len(apart)} of {computed} scenes have two steady states; {scenes - computed} have no torque.")
    if apart:
        typer.echo(f"Their torques are apart by {100 * np.median(apart):.2g} %, median, and {100 * max(apart):.2g} %.")


if __name__ == "__main__":
    typer.run(main)
