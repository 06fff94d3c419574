"""The result of a friction torque: its parts, contacts, effects and warnings, as arrays, JSON and named columns."""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, fields, replace
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from analytic.brief import Brief, points_of, span
from analytic.cage.torque import CagePart
from analytic.columns import COLUMNS, COORDINATES, MODEL_PARTS, OF_MODEL, Point, rows_of, without_residue
from analytic.effects import Effects
from analytic.errors import FembearingError, InputError
from analytic.labelled import Labelled, dataset_of, frame_of, html_table
from analytic.left_out import Places
from analytic.limits import LimitNumbers
from analytic.loads.pair import PairEquilibrium
from analytic.loads.ring_state import RingState
from analytic.scene import ArrangementKind, Array, Clearances, Sliding
from analytic.units import METRIC
from analytic.words import NEWTON_MILLIMETRE, RPM

if TYPE_CHECKING:
    from matplotlib.figure import Figure

POINT = "point"  # the dimension of a dataset
MOST_ROWS = 12  # of the table in a notebook


@dataclass(frozen=True, kw_only=True, eq=False)
class TorqueParts(Brief):
    """N m, each (n,); None where a part was left out or is not modelled."""

    total: Array  # the sum of what was computed and declared
    race: Array  # spin + conformity + hysteresis + rolling, as far as computed
    spin: Array | None
    conformity: Array | None
    hysteresis: Array | None
    rolling: Array | None = None
    cage: Array | None = None  # sliding on balls and land, and drag
    oil: Array | None = None  # outside the contacts: it flows through, is sheared at the cage, and holds the balls back
    declared: Array | None = None  # seals and drag, as the scene gives them


@dataclass(frozen=True, kw_only=True, eq=False)
class FrictionCoefficients(Brief):
    """Of each contact, (n,); None: no such contact, or nothing that slides was computed."""

    inner: Array | None  # coefficient of ball on inner race
    outer: Array | None  # coefficient of ball on outer race
    pocket: Array | None  # coefficient of ball on pocket


@dataclass(frozen=True, kw_only=True, eq=False)
class OnRaces(Brief):
    """A quantity of the contacts on both races, each (n,); None where it is not known."""

    inner: Array | None  # on the inner race, in the unit of the quantity
    outer: Array | None  # on the outer race, in the unit of the quantity


@dataclass(frozen=True, kw_only=True, eq=False)
class LoadedContact(Brief):
    """One ball on one race, each (n,)."""

    load: Array  # Q, N
    semi_axis_rolling: Array  # a, m
    semi_axis_transverse: Array  # b, m
    peak_pressure: Array  # p0, Pa
    approach: Array  # delta, m


@dataclass(frozen=True, kw_only=True, eq=False)
class PairPart(Brief):
    """What each bearing of a pair does at the n operating points of the pair."""

    kind: ArrangementKind  # how the bearings are set against each other
    equilibrium: PairEquilibrium
    bearings: "tuple[FrictionTorque | None, FrictionTorque | None]"  # at `points`, in its own frame; None: nowhere
    points: tuple[NDArray[np.intp], NDArray[np.intp]]  # numbers of the points at which each inner ring presses
    total: Array  # (2, n) torque of each bearing, N m

    def columns(self) -> dict[str, Array]:
        """The numbers of the pair and, in its own frame, of each bearing, (n,), SI; flags are 0 or 1."""
        found = self.equilibrium
        shaft = {f"shaft_{name}": getattr(found, name) for name in ("displacement", "tilt", "stiffness")}
        of_bearings = {name: getattr(found, name) for name in OF_BEARING} | {"torque": self.total}
        return shaft | {
            f"{name}_{bearing}": np.asarray(values[place], dtype=float)
            for place, bearing in enumerate(BEARINGS)
            for name, values in of_bearings.items()
        }


OF_BEARING = ("axial_load", "radial_load", "moment", "ball_load", "is_pressed", "is_relieved")  # of a pair
BEARINGS = ("first", "second")
OF_POINTS = ("torque", "film", "asperity_share", "boundary_share", "inner", "outer")


@dataclass(frozen=True, kw_only=True, eq=False)
class FrictionTorque(Brief):
    """The friction torque at every operating point of a scene; arrays have the shape (n,).

    Of a pair of bearings the parts are sums over both, and what belongs to one ball is that of the pair's heaviest.
    """

    inner_speed: Array  # rad/s
    axial_load: Array  # N
    radial_load: Array  # N
    moment: Array  # N m
    contact_angle: Array  # al, loaded, the mean of both races, rad; this and what follows of the heaviest ball
    ball_load: Array  # Q, on the race where it is larger, N
    torque: TorqueParts
    # Of the total, relative: twice what doubling the nodes of sliding changes, the residual of the equilibrium, the
    # interval of a moving cage, and a tenth of the tolerance
    numerical_uncertainty: Array
    friction_coefficient: FrictionCoefficients
    film: OnRaces  # h, mean gap that the oil fills, m; None without a lubrication model
    asperity_share: OnRaces  # s, of the load, 0 to 1; likewise
    boundary_share: OnRaces  # s_b: s, and the part of the oil that is only a molecule thick; likewise
    inner: LoadedContact
    outer: LoadedContact
    limits: LimitNumbers  # of the worst ball of all
    effects: Effects
    cage: CagePart | None  # what its torque comes from; None: left out
    ring: RingState | None  # displacement and stiffness of the ring, every ball; None for a pair
    gap_roughness: float | None  # Sq of ball and race together, that the film is compared with, m
    sliding: Sliding  # how the balls turn and slide
    warnings: tuple[str, ...]  # one line each
    provenance: Mapping[str, str]  # where decisions and numbers come from, by subject
    seconds: float = 0.0  # that the computation took, without what is computed when somebody reads it
    model_uncertainty: Array | None = None  # of the total, relative, 95 %; see analytic.torque
    model_parts: Mapping[str, Array] | None = None  # of it, relative, 95 %, by the formula that is varied
    failures: Mapping[int, FembearingError] = field(
        default_factory=dict
    )  # of points without a torque, by number from 0
    clearances: Clearances | None = None  # how the bearing came to its clearance; None: its seats are not given
    pair: PairPart | None = None  # each bearing by itself; None: there is one

    @classmethod
    def with_later(cls, later: Mapping[str, Callable[[], Any]], **known: Any) -> "FrictionTorque":
        """A result, some fields of which are computed when somebody reads them.

        Parameters
        ----------
        later : mapping of str to callable
            What computes a field, by its name.
        **known : object
            The other fields; one with a default may be left out.

        Returns
        -------
        FrictionTorque
            As by the constructor.
        """
        result = object.__new__(cls)
        vars(result).update(known, _later=later, failures={})
        return result

    if not TYPE_CHECKING:  # a checker sees the declared fields alone

        def __getattr__(self, name: str) -> Any:
            compute = vars(self).get("_later", {}).get(name)
            if compute is None:
                raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}")
            vars(self)[name] = compute()
            return vars(self)[name]

    def __getstate__(self) -> dict[str, Any]:
        return self._values()

    def _values(self) -> dict[str, Any]:
        return {each.name: getattr(self, each.name) for each in fields(self)}

    def _facts(self) -> Iterator[str]:
        yield self.provenance["scene"]
        yield points_of({name: getattr(self, name) for name in COORDINATES})
        yield f"{span(self.torque.total, NEWTON_MILLIMETRE.factor)} {NEWTON_MILLIMETRE.name}"

    def at(self, points: NDArray[np.intp]) -> "FrictionTorque":
        """The torque at some operating points; effects, warnings and what else belongs to the whole series stay.

        Parameters
        ----------
        points : ndarray, shape (k,)
            Numbers of the points, from 0.

        Returns
        -------
        FrictionTorque
            With arrays (k,).
        """
        changed = {name: _each(value, lambda values: values[points]) for name, value in self._values().items()}
        parts = {name: getattr(self, name) for name in ("cage", "limits", "ring")}
        own = {name: None if part is None else part.at(points) for name, part in parts.items()}
        return replace(self, **{**changed, **own})

    def among(self, places: Places) -> "FrictionTorque":
        """The torque at all operating points of a series, of which this has those that have settled.

        Parameters
        ----------
        places : Places
            All n points, and which of them have failed.

        Returns
        -------
        FrictionTorque
            With arrays (n,), NaN where a point has no torque.
        """
        is_lost = np.isin(np.arange(places.operation.inner_speed.size), [*places.failures])

        def without(values: NDArray[Any]) -> NDArray[Any]:
            return np.where(is_lost, np.nan, values) if values.dtype.kind == "f" else values

        spread = self.at(places.rows)
        lost = {name: _each(value, without) for name, value in spread._values().items()}
        given = {name: np.asarray(getattr(places.operation, name)) for name in COORDINATES}
        words = [f"operating point {1 + number} has no torque: {why}" for number, why in places.failures.items()]
        effects, warnings = self.effects.among(places.computed), (*self.warnings, *words)
        others = {"effects": effects, "failures": places.failures, "warnings": warnings}
        return replace(spread, **{**lost, **given, **others})

    def checked(self) -> "FrictionTorque":
        """The same. Every number that is computed already is finite, or missing for a reason that it gives.

        What was left out is None, and an effect says why; a point without a torque has NaN, and `failures` says why.

        Returns
        -------
        FrictionTorque
            This object.

        Raises
        ------
        InputError
            For any other number: the inputs lie beyond what can be computed.
        """
        groups = (vars(self), *(vars(vars(self)[name]) for name in OF_POINTS))
        for name, values in (each for group in groups for each in group.items()):
            if isinstance(values, np.ndarray) and values.dtype.kind == "f" and not np.isfinite(values).all():
                self._require_finite(name, values)
        return self

    def _require_finite(self, name: str, values: Array) -> None:
        for point in map(int, np.flatnonzero(~np.isfinite(values))):
            if point not in self.failures:
                columns = COORDINATES.items()
                given = ", ".join(f"{key} {getattr(self, key)[point]:g} {each.unit}" for key, each in columns)
                raise InputError(
                    f"{name.replace('_', ' ')} is {values[point]:g} at operating point {point + 1} ({given}): the "
                    "numbers of the scene are outside the computable range; give usual ones"
                )

    def settled(self) -> "FrictionTorque":
        """The same; raises the first of `failures`, if there is one."""
        for failure in self.failures.values():
            raise failure
        return self

    def is_on(self, name: str) -> bool:
        """Whether an effect counts.

        Parameters
        ----------
        name : str
            Of an effect, as in `scene.effects`.

        Returns
        -------
        bool
            As it was decided.
        """
        return self.effects.decisions.get(name) == "on"

    def columns(self) -> dict[str, Array]:
        """The values of COORDINATES and COLUMNS that a torque alone has, each (n,), SI; NaN: left out, not modelled."""
        values = {name: getattr(self, name) for name in COORDINATES}
        values |= {f"torque_{name}": part for name, part in vars(self.torque).items()}
        ring = None if self.ring is None or self.ring.is_loaded_alike else self.ring
        values |= {
            "uncertainty_numerical": self.numerical_uncertainty,
            "uncertainty_model": self.model_uncertainty,
            **{f"{OF_MODEL}{name}": (self.model_parts or {}).get(name) for name in MODEL_PARTS},
            "contact_angle": self.contact_angle,
            "ball_load": self.ball_load,
            "tilt": None if ring is None else ring.tilt,
            "holding_moment": None if ring is None else ring.holding_moment,
        }
        for name in ("friction_coefficient", "film", "asperity_share", "boundary_share"):
            values |= {f"{name}_{place}": part for place, part in vars(getattr(self, name)).items()}
        for race in ("inner", "outer"):
            values |= {f"{name}_{race}": part for name, part in vars(getattr(self, race)).items()}
        nothing = np.full(self.inner_speed.shape, np.nan)
        found = {name: nothing if part is None else np.asarray(part, dtype=float) for name, part in values.items()}
        return {name: without_residue(name, each) for name, each in found.items()}

    @property
    def rows(self) -> tuple[Point, ...]:
        """A row for each operating point, by the names of `columns`."""
        return rows_of(self.columns())

    def to_dataset(self) -> Any:
        """An xarray.Dataset over the operating points, with units and meanings as attributes.

        It lacks the columns that hold nothing, because their part was left out or is not modelled.
        """
        given, computed = self._labelled()
        return dataset_of(computed, coordinates=given, attributes=self.attributes())

    def _labelled(self) -> tuple[dict[str, Labelled], dict[str, Labelled]]:
        """The operating points as they are given, and what is computed there."""
        known = self.columns()
        return (
            {name: Labelled((POINT,), known[name], column) for name, column in COORDINATES.items()},
            {
                name: Labelled((POINT,), known[name], column)
                for name, column in COLUMNS.items()
                if name in known and name not in COORDINATES
            },
        )

    def attributes(self) -> dict[str, str]:
        """What a dataset says of itself: how it was computed, and its warnings."""
        return {**self.provenance, "warnings": "\n".join(self.warnings)}

    def to_dataframe(self) -> Any:
        """A pandas.DataFrame with the columns of `to_dataset`: a row for each operating point, SI."""
        given, computed = self._labelled()
        return frame_of(given | computed, POINT)

    def plot(self) -> "Figure":
        """The torque by effect over the operating points, metric: lines over speed or load, else bars.

        Returns
        -------
        matplotlib.figure.Figure
            Without the 95 % interval and the makers' formulas, which `SceneTorque.plot` has.

        Raises
        ------
        InputError
            No operating point has a torque.
        MissingPackageError
            Matplotlib is not installed.
        """
        from analytic.figures.torque import DrawnTorque, torque_figure

        given = {name: getattr(self, name) for name in COORDINATES}
        title = f"{self.provenance['scene']}, {self.provenance['oil']}"
        return torque_figure(DrawnTorque(columns=given | self.columns(), makers={}, title=title, units=METRIC))

    def _repr_html_(self) -> str:
        """A table for a notebook: a row for each operating point, the torque in N mm by effect."""
        parts = {name: part for name, part in vars(self.torque).items() if part is not None}
        sideways = {
            f"{COORDINATES[name].meaning}, {COORDINATES[name].unit}": values
            for name in ("radial_load", "moment")
            if np.any(values := getattr(self, name))
        }
        axial = COORDINATES["axial_load"]
        head = [
            f"speed, {RPM.name}",
            f"{axial.meaning}, {axial.unit}",
            *sideways,
            *(f"{name}, {NEWTON_MILLIMETRE.name}" for name in parts),
            "uncertainty, %",
        ]
        shown = min(self.inner_speed.size, MOST_ROWS)
        rows = [
            [
                f"{self.inner_speed[i] * RPM.factor:.4g}",
                f"{self.axial_load[i]:.4g}",
                *(f"{values[i]:.4g}" for values in sideways.values()),
                *(f"{part[i] * NEWTON_MILLIMETRE.factor:.4g}" for part in parts.values()),
                f"{100 * self.numerical_uncertainty[i]:.2g}"
                if np.isfinite(self.numerical_uncertainty[i])
                else "unknown",
            ]
            for i in range(shown)
        ]
        more = self.inner_speed.size - shown
        return html_table(head, rows, f"friction torque, {more} more points" if more else "friction torque")


def _each(value: Any, change: Callable[[NDArray[Any]], NDArray[Any]]) -> Any:
    """The same with changed arrays of one row for each operating point, also within groups."""
    if isinstance(value, np.ndarray):
        return change(value)
    if isinstance(value, TorqueParts | FrictionCoefficients | OnRaces | LoadedContact):
        return replace(value, **{name: _each(part, change) for name, part in vars(value).items()})
    if isinstance(value, MappingProxyType):
        return MappingProxyType({name: _each(part, change) for name, part in value.items()})
    return value
