"""The compiled loops of a free ball's rotation; `analytic.free_ball.rotation` says what they solve.

Imported on demand, because LLVM is slow to import. Rates are per unit ring speed w,
so slip is a length and an inertia carries w^2. One contact is a row of numbers (`analytic.free_ball.layout`). The nodes
of a quadrature lie on strips along rolling, at y = b sin(angle), where the pressure is smooth.
"""

import numpy as np

from analytic.free_ball.layout import (
    ACROSS,
    ALONG,
    BALL_RADIUS,
    BOUNDARY,
    EYRING,
    FLEXIBILITY,
    FRICTION,
    INERTIA,
    LAW_POWER,
    LIMIT,
    LOAD,
    MOST_STEPS,
    NORMAL_R,
    NORMAL_Z,
    ORBIT_RADIUS,
    OUTCOME,
    PLAIN,
    POWER,
    RADIUS,
    RING,
    ROLLING,
    SPIN_POWER,
    TRANSVERSE,
    UNIT_POWER,
)
from analytic.free_ball.stress import fluidity_of, sheared, yielding
from analytic.numerics.compilation import compiled

NO_SLIP = 1e-200  # m: keeps a direction where nothing slides
LEAST_TANGENT = 1e-14  # of the trace of the tangent
LEAST_SHARE = 1e-4  # of a Newton step
HARDER = 10.0  # between two stages of a ball whose Newton's method stalls
STAGES = 6


@compiled(inline=True)
def _strip_closed(law, slip, along, spread):
    """One strip by the closed law: forces and stiffness by slip along it, across it and by spin, and sums over it.

    law : of the contact;  slip : (along, across, spin);  along : sines, cosines and weights of the nodes
    spread : (half-length, flow, pressure at the middle, p0 L u/a, oil)
    """
    slide, lateral, spin = slip
    half, flow, middle, length, table, spacing = spread
    sines, cosines, weights = along
    f_p = f_l = f_n = pp = pl = pn = ll = ln = nn = law_power = unit = friction = 0.0
    for k in range(sines.shape[0]):
        pressure, area, x = middle * cosines[k], weights[k] * half * cosines[k], flow * half * sines[k]
        across = lateral + spin * x
        size = max(np.sqrt(slide * slide + across * across), NO_SLIP)
        fluidity = fluidity_of(law, pressure, table, spacing)
        steady = law[BOUNDARY] * pressure + law[PLAIN]
        stress, slope = yielding(size, steady, law[LIMIT] * pressure, law[EYRING], fluidity)
        unit += area * pressure * size
        law_power += area * stress * size
        if stress == 0.0:
            continue
        creep = size * pressure / (stress * length) if length > 0.0 else 1e100
        square = 1.0 + creep * creep
        share, steep = 2.0 / np.pi * (np.arctan(creep) + creep / square), 4.0 / np.pi / (square * square)
        over = stress * share / size
        rest = slope * (share - creep * steep) + stress * steep * creep / size - over
        e_x, e_y = slide / size, across / size
        xx, xy, yy = area * (over + rest * e_x * e_x), area * rest * e_x * e_y, area * (over + rest * e_y * e_y)
        f_p += area * over * slide
        f_l += area * over * across
        f_n += area * over * across * x
        pp += xx
        pl += xy
        pn += xy * x
        ll += yy
        ln += yy * x
        nn += yy * x * x
        friction += area * over * size
    return (f_p, f_l, f_n), (pp, pl, pn, pl, ll, ln, pn, ln, nn), (law_power, unit, friction)


@compiled(inline=True)
def _strip_marched(law, slip, along, spread):
    """One strip, marched from its leading edge; arguments and results of `_strip_closed`, p0 L u/a being L u there."""
    slide, lateral, spin = slip
    half, flow, middle, length, table, spacing = spread
    sines, cosines, weights = along
    f_p = f_l = f_n = pp = pl = pn = lp = ll = ln = np_ = nl = nn = law_power = unit = friction = 0.0
    stress_x = stress_y = older_x = older_y = gone = 0.0
    xp = xl = xn = yp = yl = yn = old_xp = old_xl = old_xn = old_yp = old_yl = old_yn = 0.0
    here = -half
    for k in range(sines.shape[0]):
        pressure, area, x = middle * cosines[k], weights[k] * half * cosines[k], flow * half * sines[k]
        # Second-order backward differences. The first step is exact where nothing slides.
        step = half * sines[k] - here
        here = half * sines[k]
        ratio = step / gone if gone > 0.0 else 0.0
        per_step = length / step
        compliance = per_step * (1.0 + 2.0 * ratio) / (1.0 + ratio)
        from_last, from_older = per_step * (1.0 + ratio), per_step * ratio * ratio / (1.0 + ratio)
        acting = x if gone > 0.0 else x - flow * step / 2.0
        gone = step
        reach_x = slide + from_last * stress_x - from_older * older_x
        reach_y = lateral + spin * acting + from_last * stress_y - from_older * older_y
        reach = max(np.sqrt(reach_x * reach_x + reach_y * reach_y), NO_SLIP)
        older_x, older_y = stress_x, stress_y
        fluidity = fluidity_of(law, pressure, table, spacing)
        steady = law[BOUNDARY] * pressure + law[PLAIN]
        stress, slope = sheared(reach, compliance, steady, law[LIMIT] * pressure, law[EYRING], fluidity)
        e_x, e_y, over = reach_x / reach, reach_y / reach, stress / reach
        stress_x, stress_y = stress * e_x, stress * e_y
        xx, xy = over + (slope - over) * e_x * e_x, (slope - over) * e_x * e_y
        yy = over + (slope - over) * e_y * e_y
        to_xp, to_yp = 1.0 + from_last * xp - from_older * old_xp, from_last * yp - from_older * old_yp
        to_xl, to_yl = from_last * xl - from_older * old_xl, 1.0 + from_last * yl - from_older * old_yl
        to_xn, to_yn = from_last * xn - from_older * old_xn, acting + from_last * yn - from_older * old_yn
        old_xp, old_xl, old_xn, old_yp, old_yl, old_yn = xp, xl, xn, yp, yl, yn
        xp, yp = xx * to_xp + xy * to_yp, xy * to_xp + yy * to_yp
        xl, yl = xx * to_xl + xy * to_yl, xy * to_xl + yy * to_yl
        xn, yn = xx * to_xn + xy * to_yn, xy * to_xn + yy * to_yn
        f_p += area * stress_x
        f_l += area * stress_y
        f_n += area * stress_y * x
        pp, pl, pn = pp + area * xp, pl + area * xl, pn + area * xn
        lp, ll, ln = lp + area * yp, ll + area * yl, ln + area * yn
        np_, nl, nn = np_ + area * yp * x, nl + area * yl * x, nn + area * yn * x
        across = lateral + spin * x
        size = np.sqrt(slide * slide + across * across)
        without, _ = yielding(size, steady, law[LIMIT] * pressure, law[EYRING], fluidity)
        law_power += area * without * size
        unit += area * pressure * size
        friction += area * stress
    return (f_p, f_l, f_n), (pp, pl, pn, lp, ll, ln, np_, nl, nn), (law_power, unit, friction)


@compiled
def _contact(contact, ball, velocity, passing, quadrature, outcome, sums):
    """Add one contact to sums: forces A^T stress and their tangent; write its outcome.

    passing : velocity of the surfaces through the contact, m per unit w, with its sign
    quadrature : (sines, cosines and weights of the strips; those of their nodes; whether traction is marched; ln of the
        oil's thickening at equal steps of the pressure; this step, Pa)
    """
    (sines, cosines, weights), along, marched, table, spacing = quadrature
    force, tangent = sums
    a, b = contact[ROLLING], contact[TRANSVERSE]
    n_r, n_z, ring, size = contact[NORMAL_R], contact[NORMAL_Z], contact[RING], ball[BALL_RADIUS]
    peak = 1.5 * contact[LOAD] / (np.pi * a * b)
    spin = (n_r * velocity[2] + n_z * velocity[3]) / size - ring * n_z
    flow = 1.0 if passing >= 0.0 else -1.0
    length = contact[FLEXIBILITY] * abs(passing) * (a if marched else peak)
    for c in range(OUTCOME):
        outcome[c] = 0.0
    rows = np.zeros((3, 4))  # what the velocity does to the slip along the strip, across it, and to spin
    rows[0, 0], rows[2, 2], rows[2, 3] = 1.0, n_r / size, n_z / size
    for j in range(sines.shape[0]):
        y = b * sines[j]
        depth = size - y * y / (2.0 * contact[RADIUS])
        rows[0, 2], rows[0, 3] = (-depth * n_z - y * n_r) / size, (depth * n_r - y * n_z) / size
        rows[1, 1] = -depth / size
        slide = velocity[0] + rows[0, 2] * velocity[2] + rows[0, 3] * velocity[3]
        slide -= ring * (ball[ORBIT_RADIUS] + depth * n_r - y * n_z)
        slip = (slide, rows[1, 1] * velocity[1], spin)
        spread = (a * cosines[j], flow, peak * cosines[j], length, table, spacing)
        if marched:
            forces, stiffness, (law_power, unit, friction) = _strip_marched(contact, slip, along, spread)
        else:
            forces, stiffness, (law_power, unit, friction) = _strip_closed(contact, slip, along, spread)
        width = weights[j] * b * cosines[j]
        for i in range(3):
            for c in range(4):
                force[c] += width * forces[i] * rows[i, c]
                for k in range(3):
                    for d in range(4):
                        tangent[c, d] += width * stiffness[3 * i + k] * rows[i, c] * rows[k, d]
        outcome[ALONG] -= width * forces[0]
        outcome[ACROSS] -= width * forces[1]
        outcome[POWER] += width * (forces[0] * slide + forces[1] * slip[1] + forces[2] * spin)
        outcome[SPIN_POWER] += width * (forces[2] - forces[0] * y) * spin
        outcome[LAW_POWER] += width * law_power
        outcome[UNIT_POWER] += width * unit
        outcome[FRICTION] += width * friction


@compiled(inline=True)
def _passing(contact, ball, velocity):
    """Mean velocity of both surfaces through the contact, m per unit w, along the orbit."""
    orbit = velocity[0] / ball[ORBIT_RADIUS]
    turns = -contact[NORMAL_Z] * velocity[2] + contact[NORMAL_R] * (velocity[3] - ball[BALL_RADIUS] * orbit)
    passes = (contact[RING] - orbit) * (ball[ORBIT_RADIUS] + ball[BALL_RADIUS] * contact[NORMAL_R])
    return (turns + passes) / 2.0


@compiled
def _hold(contact, sums):
    """Leave a ball that one race touches one freedom, its speed of rolling there, which leaves no force along rolling.

    Nothing drives it round its orbit or holds its axis: it keeps both, as the cage and its own inertia would have it.
    """
    force, tangent = sums
    t_r, t_z = -contact[NORMAL_Z], contact[NORMAL_R]
    moment = t_r * force[2] + t_z * force[3]
    stiffness = t_r * (t_r * tangent[2, 2] + t_z * tangent[2, 3]) + t_z * (t_r * tangent[3, 2] + t_z * tangent[3, 3])
    force[0] = force[1] = 0.0
    force[2], force[3] = moment * t_r, moment * t_z
    tangent[:] = 0.0
    for c in range(4):
        tangent[c, c] = stiffness


@compiled
def _residual(contacts, ball, velocity, passing, quadrature, outcome, sums):
    """What the ball's equilibrium lacks and its tangent, into sums; returns the sum of all friction.

    A ball that one race alone touches only rolls on it: see `_hold`.
    """
    force, tangent = sums
    force[:] = 0.0
    tangent[:] = 0.0
    for race in range(2):
        if contacts[race, LOAD] > 0.0:
            _contact(contacts[race], ball, velocity, passing[race], quadrature, outcome[race], sums)
        else:
            outcome[race, :] = 0.0
    gyro = ball[INERTIA] / ball[ORBIT_RADIUS]
    force[1] += gyro * velocity[0] * velocity[2]
    force[2] -= gyro * velocity[0] * velocity[1]
    tangent[1, 0] += gyro * velocity[2]
    tangent[1, 2] += gyro * velocity[0]
    tangent[2, 0] -= gyro * velocity[1]
    tangent[2, 1] -= gyro * velocity[0]
    if contacts[0, LOAD] == 0.0 or contacts[1, LOAD] == 0.0:
        _hold(contacts[0] if contacts[0, LOAD] > 0.0 else contacts[1], sums)
        outcome[0, ACROSS] = outcome[1, ACROSS] = 0.0
    return outcome[0, FRICTION] + outcome[1, FRICTION]


@compiled
def _roll(contact, ball, velocity):
    """Let a ball roll on one race without slip at the contact's centre: a start for what `_hold` leaves it."""
    n_r, n_z = contact[NORMAL_R], contact[NORMAL_Z]
    slide = velocity[0] - n_z * velocity[2] + n_r * velocity[3]
    slide -= contact[RING] * (ball[ORBIT_RADIUS] + ball[BALL_RADIUS] * n_r)
    velocity[2] += n_z * slide
    velocity[3] -= n_r * slide


@compiled(inline=True)
def _solved(matrix, right):
    """The solution of a system of four by elimination with pivots; both are overwritten."""
    for column in range(4):
        best = column
        for row in range(column + 1, 4):
            if abs(matrix[row, column]) > abs(matrix[best, column]):
                best = row
        if best != column:
            for c in range(4):
                matrix[column, c], matrix[best, c] = matrix[best, c], matrix[column, c]
            right[column], right[best] = right[best], right[column]
        for row in range(column + 1, 4):
            factor = matrix[row, column] / matrix[column, column]
            right[row] -= factor * right[column]
            for c in range(column, 4):
                matrix[row, c] -= factor * matrix[column, c]
    for column in range(3, -1, -1):
        for c in range(column + 1, 4):
            right[column] -= matrix[column, c] * right[c]
        right[column] /= matrix[column, column]


@compiled
def _newton(contacts, ball, velocity, passing, quadrature, tolerance, outcome):
    """Damped Newton's method; the velocity is overwritten. Returns the residual over all friction.

    A step counts where the simplified Newton step from its end is shorter [Deuflhard2004]: forces along the orbit and
    moments of spin differ so much in stiffness that no norm of the residual serves both.
    """
    force, tangent = np.zeros(4), np.zeros((4, 4))
    trial, trial_force, trial_tangent = np.zeros(4), np.zeros(4), np.zeros((4, 4))
    step, next_step = np.zeros(4), np.zeros(4)
    friction = _residual(contacts, ball, velocity, passing, quadrature, outcome, (force, tangent))
    if friction == 0.0:
        return 0.0
    share = 1.0
    for _ in range(MOST_STEPS):
        if np.sqrt(np.sum(force * force)) <= tolerance * friction:
            break
        held = LEAST_TANGENT * (tangent[0, 0] + tangent[1, 1] + tangent[2, 2] + tangent[3, 3])
        for c in range(4):
            tangent[c, c] += held
        step[:] = -force
        _solved(tangent.copy(), step)
        length = np.sqrt(np.sum(step * step))
        share = min(1.0, 4.0 * share)
        while True:
            trial[:] = velocity + share * step
            tried = _residual(contacts, ball, trial, passing, quadrature, outcome, (trial_force, trial_tangent))
            next_step[:] = -trial_force
            _solved(tangent.copy(), next_step)
            if np.sqrt(np.sum(next_step * next_step)) <= (1.0 - share / 4.0) * length or share < LEAST_SHARE:
                break
            share *= 0.5
        if share < LEAST_SHARE:
            _residual(contacts, ball, velocity, passing, quadrature, outcome, (force, tangent))  # not the trial's
            break
        velocity[:], force[:], tangent[:] = trial, trial_force, trial_tangent
        friction = tried
    return np.sqrt(np.sum(force * force)) / friction


@compiled
def rotate(contacts, balls, velocities, quadrature, tolerance, outcomes):
    """Turn balls to where no moment and no force along the orbit is left on them; returns the residual of each.

    contacts : (m, 2, CONTACT);  balls : (m, BALL);  velocities : (m, 4) start, overwritten;  outcomes : (m, 2, OUTCOME)
    quadrature : as in `_contact`
    The speed of the surfaces through each contact is that of the start. Where Newton's method stalls, softer surfaces
    come first: they creep as if the speed through the contact were higher.
    """
    count = balls.shape[0]
    residuals = np.zeros(count)
    passing, start = np.zeros(2), np.zeros(4)
    for index in range(count):
        contact, ball, velocity, outcome = contacts[index], balls[index], velocities[index], outcomes[index]
        for race in range(2):
            passing[race] = _passing(contact[race], ball, velocity)
        if contact[0, LOAD] == 0.0 or contact[1, LOAD] == 0.0:
            _roll(contact[0] if contact[0, LOAD] > 0.0 else contact[1], ball, velocity)
        start[:] = velocity
        left = _newton(contact, ball, velocity, passing, quadrature, tolerance, outcome)
        if left > tolerance:
            velocity[:] = start
            softer = HARDER**STAGES
            for _ in range(STAGES + 1):
                left = _newton(contact, ball, velocity, softer * passing, quadrature, tolerance, outcome)
                softer /= HARDER
        residuals[index] = left
    return residuals
