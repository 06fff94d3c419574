"""The order of the examples in the gallery: from a first torque to the special."""

ORDER = (
    "plot_torque_by_designation.py",
    "plot_oils_and_temperature.py",
    "plot_torque_map.py",
    "plot_interval.py",
    "plot_radial_load.py",
    "plot_preloaded_pair.py",
    "plot_measured_roughness.py",
    "plot_spinning_down_shaft.py",
    "plot_cage_motion.py",
    "plot_contact_by_finite_elements.py",
    "plot_stiffness_law.py",
    "plot_thin_sheet.py",
)


def place(example: str) -> int:
    """The place of an example. Raises ValueError for one that ORDER lacks."""
    return ORDER.index(example)
