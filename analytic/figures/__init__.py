"""Figures of a torque, and what all figures share."""
