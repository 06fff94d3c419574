"""Elastic contact of two bodies by finite elements, on the meshes of `fembearing.mesh`.

Takes nothing of the production model but its nouns: a check that borrows what it checks proves nothing.
"""
