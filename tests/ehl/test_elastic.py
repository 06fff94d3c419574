import numpy as np
import pytest
from scipy.integrate import dblquad

from fembearing.ehl.elastic import half_space_integrals
from fembearing.ehl.grid import Grid, graded_faces
from fembearing.fem.half_space import approach_under, curvatures_under


def test_integrals_are_those_of_quadrature() -> None:
    x_faces, y_faces = np.array([-1.3, -0.2, 0.9, 2.3]), np.array([0.0, 0.4, 1.7])
    x, y = (x_faces[1:] + x_faces[:-1]) / 2, (y_faces[1:] + y_faces[:-1]) / 2
    found = half_space_integrals(x, y, x_faces, y_faces)
    for at, of in ((0, 5), (3, 0), (1, 2)):  # none inside its own cell, where 1/r is singular
        centre = x[at // 2], y[at % 2]
        k, m = of // 2, of % 2
        exact = 0.0
        for side in (1, -1):
            exact += dblquad(
                lambda v, u, side=side, centre=centre: 1 / np.hypot(u - centre[0], side * v - centre[1]),
                x_faces[k],
                x_faces[k + 1],
                y_faces[m],
                y_faces[m + 1],
            )[0]
        assert found[at, of] == pytest.approx(exact, rel=1e-7)  # the quadrature's own tolerance


def test_hertz_pressure_on_an_ellipse_gives_the_paraboloid_of_its_curvatures() -> None:
    a, b, load, modulus = 0.8, 1.7, 2.6, 1.9
    grid = Grid(
        x_faces=graded_faces([-0.9, 0.9], [0.04, 0.04], refinement=1.0),
        y_faces=graded_faces([0.0, 1.9], [0.06, 0.06], refinement=1.0),
    )
    x, y = np.broadcast_arrays(grid.x[:, None], grid.y[None, :])
    pressure = 1.5 * load / (np.pi * a * b) * np.sqrt(np.maximum(1 - (x / a) ** 2 - (y / b) ** 2, 0.0))
    integrals = half_space_integrals(grid.x, grid.y, grid.x_faces, grid.y_faces)
    deflection = (integrals @ pressure.ravel()).reshape(grid.shape) / (np.pi * modulus)
    first, second = curvatures_under((a, b), load=load, modulus=modulus)
    exact = approach_under((a, b), load=load, modulus=modulus) - first * x**2 / 2 - second * y**2 / 2
    inside = (x / a) ** 2 + (y / b) ** 2 < 0.8
    # Cells of 1/20 of a semi-axis, and an edge that cuts through them
    np.testing.assert_allclose(deflection[inside], exact[inside], rtol=4e-3)
