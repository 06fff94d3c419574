"""Meshes of a ball, a groove and their idealisation, each made from a recipe.

Frame of every mesh: the origin is the centre of the contact, x the rolling direction, y the transverse direction with
the nearer shoulder at y > 0, and z the direction of the load into the ball; the ball lies at z > 0, the race at z < 0.
A mesh is a quarter, x >= 0 and y >= 0, with the planes of symmetry x = 0 and y = 0. Where the contact is cut off at one
shoulder, the mesh is a half, x >= 0, without the second symmetry.
"""
