"""What all tables of the document share: strict types, numbers that are finite, and lists that belong together."""

from typing import Annotated, Any, Generic, Literal, Self, TypeVar

from pydantic import BaseModel, ConfigDict, Field, field_validator, model_validator

T = TypeVar("T")
Pair = Literal["inner", "outer", "pocket"]
Geometry = Literal["real", "hertzian", "wall", "ring"]
Verdict = Literal["pass", "fail", "undecided", "outside validity"]
Positive = Annotated[float, Field(gt=0)]
NotNegative = Annotated[float, Field(ge=0)]
Two = Annotated[list[float], Field(min_length=2, max_length=2)]  # JSON has no tuples
Numbers = Annotated[list[float], Field(min_length=1)]
Count = Annotated[int, Field(gt=0, lt=2**63)]
Label = Annotated[str, Field(pattern=r"^[^$]*$")]  # in a figure, where dollars would begin a formula
LARGEST = 1e200  # SI; a larger number is damage, and may be too large in the unit in which it is shown


class Table(BaseModel):
    """A table of the document; a key that it does not name is refused, so that none gets lost. Numbers are SI."""

    model_config = ConfigDict(extra="forbid", strict=True, allow_inf_nan=False, frozen=True)

    @field_validator("*")
    @classmethod
    def numbers_can_be_shown(cls, value: Any) -> Any:
        for number in value if isinstance(value, list) else (value,):
            if isinstance(number, float) and abs(number) > LARGEST:
                raise ValueError(f"{number:g} is larger than {LARGEST:g}")
        return value


class OfQuantities(Table, Generic[T]):
    """One entry for each quantity of a contact that is compared."""

    approach: T
    semi_axis_rolling: T
    semi_axis_transverse: T
    peak_pressure: T
    stiffness: T

    def __getitem__(self, quantity: str) -> T:
        return getattr(self, quantity)


class OnRaces(Table):
    """A number of each race; None where it is not known."""

    inner: float | None
    outer: float | None


class OnContacts(OnRaces):
    """A number of each race and of the pocket."""

    pocket: float | None


class Series(Table):
    """Lists of one length, whose entries belong together."""

    @model_validator(mode="after")
    def each_entry_has_its_others(self) -> Self:
        """Refuse lists that differ in length."""
        check_lengths(*(values for _, values in self))
        return self


def check_lengths(*lists: list[object] | list[float] | list[float | None]) -> None:
    """Raise ValueError for lists that belong together and are not of one length."""
    lengths = sorted({len(each) for each in lists})
    if len(lengths) > 1:
        raise ValueError(f"has lists of {' and '.join(map(str, lengths))} values that belong together")
