"""Meshes of a ball, a groove and their idealisation, each made from a recipe.

Frame of every mesh: origin at the contact's centre, z along the load and into the ball, x along
rolling, y transverse, the nearer shoulder at y > 0; the ball lies at z > 0, the race at z < 0. A mesh is a quarter,
x >= 0 and y >= 0; the planes x = 0 and y = 0 are planes of symmetry. Where the contact is cut off at one shoulder it
is a half, x >= 0, without the second symmetry.
"""
