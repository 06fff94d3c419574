"""Pressed surfaces against closed solutions of a wavy one, the conditions of contact, and another program."""

import numpy as np
import pytest

from analytic.errors import InputError
from analytic.scene import Array, Autocorrelation
from analytic.surface.boundary_elements import MISSED, pressed
from analytic.surface.roughness import generated_surface

POINTS = 2048  # along a wave


def rough(points: int = 120, seed: int = 31) -> Array:
    autocorrelation = Autocorrelation(kind="gaussian", length=12e-6, spacing=1e-6)
    return generated_surface(rms_roughness=0.3e-6, autocorrelation=autocorrelation, points=points, seed=seed).heights


def wave(*, periodic: bool) -> Array:
    """Half a wave between its mirrors, or a whole one, along the columns."""
    x = (np.arange(POINTS) + 0.5) / POINTS
    profile = 2.7 * np.cos((2 if periodic else 1) * np.pi * x)
    return np.repeat(profile[:, None], 2, axis=1)


def slope_of(heights: Array) -> float:
    """In rms heights per point."""
    return float(np.sqrt(sum(np.mean(np.diff(heights, axis=axis) ** 2) for axis in (0, 1))) / heights.std())


def full_pressure(heights: Array, *, periodic: bool) -> float:
    """p* = pi E* A/lambda over E* slope, with A = sqrt(2) rms heights: above it the wave is flat."""
    return np.pi * np.sqrt(2) / (POINTS if periodic else 2 * POINTS) / slope_of(heights)


@pytest.mark.parametrize("periodic", [True, False])
@pytest.mark.parametrize("half_width", [0.11, 0.25, 0.43])
def test_a_wave_agrees_with_the_closed_solution(periodic: bool, half_width: float) -> None:
    """[Westergaard1939]: contact from -a to a on each crest, s = sin(pi a/lambda), mean pressure s^2 p*.

    p = 2 p* cos(t) sqrt(s^2 - sin(t)^2), t = pi x/lambda. The gap's slope has the same form with sin(t)^2 - s^2, hence
    g = 4 A times the integral of sqrt(w^2 - s^2) from s to sin(t).
    """
    s, heights = np.sin(np.pi * half_width), wave(periodic=periodic)
    full = full_pressure(heights, periodic=periodic)
    (state,) = pressed(heights, (full * s**2,), periodic=periodic)
    t = (np.arange(POINTS) + 0.5) / POINTS * (np.pi if periodic else np.pi / 2)
    cosine, w = np.abs(np.cos(t)), np.sin(t)
    wrong = state.pressure[:, 0] - 2 * full * cosine * np.sqrt(np.maximum(s**2 - w**2, 0))
    inside = w < np.sin(0.9 * np.pi * half_width)
    assert np.max(np.abs(wrong[inside])) < 0.01 * full  # 1e-3 of the gap, and the pressure of short waves is large
    assert np.mean(np.abs(wrong)) < 2e-3 * full  # at the rim single points are worse
    w = np.maximum(w, s)
    root = np.sqrt(w**2 - s**2)
    gap = np.sqrt(2) * 2 * (w * root - s**2 * np.log((w + root) / s))
    np.testing.assert_allclose(state.gap[:, 0], gap, atol=0.01 * gap.mean())  # 1e-3 in the mean, more at the rim
    np.testing.assert_allclose(state.mean_gap, gap.mean(), rtol=2 * MISSED)
    assert state.area_fraction == pytest.approx(2 * half_width, abs=8 / POINTS)  # points at both rims


@pytest.mark.parametrize("periodic", [True, False])
def test_pressure_and_gap_are_those_of_a_contact(periodic: bool) -> None:
    """Balance, p g = 0, and a gap that is the height of the surface over the ground that the pressure has bent."""
    heights, pressures = rough(), (0.6, 0.13, 0.004)
    for mean, state in zip(pressures, pressed(heights, pressures, periodic=periodic), strict=True):
        assert state.pressure.mean() == pytest.approx(mean, rel=1e-12)
        assert state.pressure.min() == 0
        assert state.gap.min() == 0
        assert np.all(state.pressure * state.gap == 0)
        bent = bent_by(state.pressure, slope_of(heights), periodic) - heights / heights.std()
        wrong = bent - bent.min() - state.gap
        assert np.ptp(wrong) < 0.03, "in rms heights: the worst point, where the mean is 1e-3 of the mean gap"
        assert np.std(wrong) < 2 * MISSED


def bent_by(pressure: Array, slope: float, periodic: bool) -> Array:
    """u(q) = 2 p(q)/(E* q), by the transform of the surface and all of its mirror images."""
    if not periodic:
        half = np.concatenate([pressure, pressure[::-1]])
        pressure = np.concatenate([half, half[:, ::-1]], axis=1)
    rows, columns = pressure.shape
    q = 2 * np.pi * np.hypot(np.fft.fftfreq(rows)[:, None], np.fft.fftfreq(columns))
    q[0, 0] = np.inf
    bent = np.fft.ifft2(np.fft.fft2(pressure) * 2 * slope / q).real
    return bent if periodic else bent[: rows // 2, : columns // 2]


@pytest.mark.parametrize("mean", [0.5, 0.08, 0.01])
@pytest.mark.parametrize("periodic", [True, False])
def test_tamaas_agrees(mean: float, periodic: bool) -> None:
    tamaas = pytest.importorskip("tamaas", reason="its wheels are for Linux on x86-64 only")
    heights = rough(128, seed=5)
    (state,) = pressed(heights, (mean,), periodic=periodic)
    surface, scale = heights / heights.std(), slope_of(heights)
    if not periodic:
        half = np.concatenate([surface, surface[::-1]])
        surface = np.concatenate([half, half[:, ::-1]], axis=1)
    tamaas.set_log_level(tamaas.LogLevel.error)
    sides = list(surface.shape)
    model = tamaas.ModelFactory.createModel(tamaas.model_type.basic_2d, [float(n) for n in sides], sides)
    model.E, model.nu = 1.0, 0.0
    tamaas.PolonskyKeerRey(model, surface, 1e-10).solve(mean * scale)
    touching = np.array(model.traction) > 0
    gap = np.array(model.displacement) - surface
    assert state.mean_gap == pytest.approx(gap.mean() - gap[touching].mean(), rel=MISSED)
    assert state.area_fraction == pytest.approx(touching.mean(), rel=0.01)  # points at the rim of small contacts


@pytest.mark.parametrize("heights", [np.zeros((40, 41)), np.full((40, 41), np.nan)])
def test_no_roughness_is_refused(heights: Array) -> None:
    with pytest.raises(InputError, match="rough surface"):
        list(pressed(heights, (0.1,), periodic=False))
