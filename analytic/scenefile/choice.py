"""What `fembearing init` writes beside a bearing. It imports little, because the help of the command shows it."""

from dataclasses import dataclass


@dataclass(frozen=True, kw_only=True)
class Choice:
    """What a written scene gives beside its bearing; as in a scene file."""

    axial_load: str | None = None  # None of both loads: a light load that suits the bearing
    radial_load: str | None = None
    inner_speed: str = "1000 rpm"
    oil: str = "ISO VG 68"
    temperature: str = "60 degC"


USUAL = Choice()
