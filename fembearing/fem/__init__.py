"""Elastic contact of two bodies by finite elements, on the meshes of `fembearing.mesh`.

It imports the nouns of the production model and none of its formulas: a check must not use what it checks.
"""
