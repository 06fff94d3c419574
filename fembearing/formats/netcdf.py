"""The torque map as netCDF, SI: axes are coordinates; units, meanings and the scene are attributes."""

import json
from pathlib import Path

from analytic.columns import COORDINATES
from analytic.labelled import Column, Labelled, dataset_of
from analytic.progress import Progress
from analytic.scenefile.read import SceneByTemperature
from fembearing.formats.axes import Axes
from fembearing.formats.torque_map import OF_OPERATION, mapped_torque
from fembearing.provenance import provenance_of

TORQUES = {  # in the order of a map
    "torque_low": Column("N m", "lower end of the 95 % interval of the friction torque, to first order"),
    "torque": Column("N m", "friction torque; it opposes the rotation"),
    "torque_high": Column("N m", "upper end of the 95 % interval of the friction torque, to first order"),
}
TEMPERATURE = Column("K", "temperature of the oil at the inlets")


def write_netcdf(given: SceneByTemperature, axes: Axes, file: Path, progress: Progress) -> tuple[str, ...]:
    """Write the map as a dataset of three variables over the axes."""
    found = mapped_torque(given, axes, progress=progress)
    names = {name: OF_OPERATION.get(name, name) for name in axes}
    origin = provenance_of(given.scene)
    dataset = dataset_of(
        {
            name: Labelled(tuple(names.values()), values, column)
            for (name, column), values in zip(TORQUES.items(), found.torque, strict=True)
        },
        coordinates={
            names[name]: Labelled((names[name],), values, COORDINATES.get(names[name], TEMPERATURE))
            for name, values in axes.items()
        },
        attributes={
            "title": f"friction torque of {given.scene.name}",
            "fembearing": origin.versions["fembearing"],
            "date": origin.date,
            "scene": json.dumps(origin.scene_content),
            "standstill": "at speed 0 the torque is that at which the bearing begins to turn",
        },
    )
    dataset.to_netcdf(file, engine="netcdf4")
    return ()
