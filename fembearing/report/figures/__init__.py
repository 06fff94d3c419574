"""Plots of a report and of sweeps, drawn from the document."""
