"""Where the inputs come from, and which effects count."""

from fembearing.report.page.sections.grid import Grid, Head, grid_of
from fembearing.report.phrases import share_of, value_of
from fembearing.report.report import Report


def inputs_grid(document: Report) -> Grid | None:
    """Each input with its origin; None without a torque."""
    if document.torque is None or not document.torque.inputs:
        return None
    heads = [Head("input", "text"), Head("value", "name"), Head("status", "text"), Head("source", "text")]
    rows = [
        [each.key, value_of(each.value, each.uncertainty, each.unit, document.units), each.status, each.source]
        for each in document.torque.inputs
    ]
    return grid_of("where the inputs come from", heads, rows)


def effects_grid(document: Report) -> Grid | None:
    """Each effect with its decision; None without a torque."""
    if document.torque is None or not document.torque.effects:
        return None
    heads = [Head("effect", "name"), Head("decision", "text"), Head("share", "number"), Head("reason", "text")]
    rows = [
        [each.name.replace("_", " "), each.decision, share_of(each.share_is, each.share), each.reason]
        for each in document.torque.effects
    ]
    return grid_of("effects", heads, rows)
