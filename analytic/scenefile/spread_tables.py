"""The tables of a scene file whose keys are those of inputs, which `analytic.inputs` lists.

[uncertainty]: how uncertain each is, as a standard deviation. A percentage is a share of the input's value; a quantity,
or a pure number, is the standard deviation itself. [assumed]: inputs that the scene gives although nobody knows them,
each with its source.
"""

from dataclasses import dataclass
from typing import Annotated, Any

from pydantic import Field

from analytic.errors import InputError
from analytic.inputs import (
    ASSUMABLE,
    LARGEST_SHARE,
    UNCERTAIN,
    Varied,
    checked_deviation,
    known_inputs,
    uncertain_value,
)
from analytic.scene import Scene
from analytic.scenefile.quantity import Dimension
from analytic.scenefile.table import Table, Text, given_paths, table_of_paths

SHARE = Dimension(unit="", low=0, high=LARGEST_SHARE, example='"10 %"')
# Standard deviation, by the unit. That it is at most 300 % of the value is checked too.
MOST = {"": 3.0, "m": 0.01, "rad": 1.0, "N": 1e6, "N m": 1e4, "N/m": 0.1, "K": 100.0, "Pa": 1e10, "1/Pa": 1e-7}
MOST |= {"Pa*s": 10.0, "m^3/s": 1.0}


@dataclass(frozen=True, kw_only=True)
class GivenSpread:
    """A standard deviation as a scene gives it."""

    value: float
    is_share: bool  # of the input's value; else in its unit, SI


@dataclass(frozen=True, kw_only=True)
class Spread(Dimension):
    """What a standard deviation accepts; `read` accepts only one in the unit of the input, as a sweep steps through."""

    takes_share: bool

    def field_value(self, given: object) -> GivenSpread:
        """Raises ValueError that says what is wrong and what is accepted."""
        if isinstance(given, str) and given.rstrip().endswith("%"):
            if not self.takes_share:
                raise ValueError(f"is a share, but this input needs the standard deviation itself; {self.accepted}")
            return GivenSpread(value=SHARE.read(given), is_share=True)
        return GivenSpread(value=self.read(given), is_share=False)


def _field(varied: Varied) -> Any:
    dimension = Spread(
        unit=varied.unit,
        low=0.0,
        high=MOST[varied.unit],
        example=varied.example,
        takes_share=varied.floor == 0,
    )
    return Annotated[GivenSpread | None, dimension], None


UncertaintyTable = table_of_paths(
    "uncertainty",
    {key: _field(varied) for key, varied in UNCERTAIN.items()},
    hint='give a table [uncertainty] of lubricant.viscosity = "6 %" and others',
)
Source = Annotated[Text, Field(description="give the source of the value in words")]
AssumedTable = table_of_paths(
    "assumed",
    dict.fromkeys(ASSUMABLE, (Source | None, None)),
    hint='give a table [assumed] of lubricant.viscosity = "the source" and others',
)


def given_spreads(table: Table, scene: Scene) -> tuple[dict[str, float], list[tuple[str, str]]]:
    """Standard deviations by key, SI, and (key, problem) for those that do not fit the scene."""
    spreads, misfits = {}, []
    for key, given in given_paths(table):
        value = uncertain_value(scene, key)
        if value is None:
            problem = "is of an input that this scene lacks or its torque does not depend on; leave it out"
            misfits.append((f"uncertainty.{key}", problem))
            continue
        try:
            deviation = given.value * value if given.is_share else given.value
            spreads[key] = checked_deviation(key, value, deviation)
        except InputError as problem:
            misfits.append((f"uncertainty.{key}", str(problem).partition(": ")[2]))
    return spreads, misfits


def given_assumptions(table: Table, scene: Scene) -> tuple[dict[str, str], list[tuple[str, str]]]:
    """Sources by key, and (key, problem) for those of an input that the scene does not have."""
    sources: dict[str, str] = dict(given_paths(table))
    known = known_inputs(scene)
    problem = "is of an input that this scene does not have; leave it out"
    return sources, [(f"assumed.{key}", problem) for key in sources if key not in known]
