"""Forces of one strip of a contact along rolling, compiled, with their stiffness.

Rates are per unit ring speed w, so slip is a length. Contacts and nodes are records of `analytic.free_ball.state`.
"""

import numpy as np

from analytic.free_ball.state import CONTACT_STATE, PITCH, QUADRATURE, ROWS
from analytic.free_ball.stress import FAST, Shear, flow_at, sheared, sheared_by_own
from analytic.numerics.compilation import compiled
from analytic.numerics.machine_code import entry
from analytic.numerics.records import Record
from analytic.oil.traction import PointLaw
from analytic.scene import Array

# Where the rows begin: of slip along, across and by spin, half-length and L u over it; stress at the last node and the
# one before; reach of slip at a node, how much less stiff it is than along, and stress and slope there. Then sums of
# three forces and of friction, and for each kind of slip four rows of what it does to both stresses, and three of its
# stiffness.
SLIDE, LATERAL, SPIN, HALF, PER_STEP = range(0, 5 * PITCH, PITCH)
STRESS_X, STRESS_Y, OLDER_X, OLDER_Y = range(5 * PITCH, 9 * PITCH, PITCH)
REACH_X, REACH_Y, REACH, STIFFER, STRESS, SLOPE = range(9 * PITCH, 15 * PITCH, PITCH)
FORCES, ALL_FRICTION = 15 * PITCH, 18 * PITCH
BY_SLIDE, BY_LATERAL, BY_SPIN = range(19 * PITCH, 40 * PITCH, 7 * PITCH)
NO_SLIP = 1e-200  # m: keeps a direction where nothing slides
NO_SQUARE = 1e-300  # m^2: likewise of its square


@compiled(fastmath=FAST)
def turned_stress(reach, sizes, stress, slope, compliance, lean):
    """Stress along and across of a point, and its slopes by the reach: xx, xy, yx, yy.

    reach : slip without this point's own stress, along and across;  sizes : |r| and |r|/|(r_x, r_y/lean)|
    stress, slope : of the law, at the compliance c_e = c times the second size;  compliance : c, along
    lean : how much more it is across
    What sticks leans to the stiffer direction, and what slides opposes the slip, of the size g = |r| - c_e T: the
    stress is along (r_x/(g + c T), r_y/(g + lean c T)). That is exact where nothing slides and where the slip is large.
    """
    r_x, r_y = reach
    size, stiffer = sizes
    per_size, even, square = 1.0 / size, compliance * stiffer, stiffer * stiffer
    e_x, e_y = r_x * per_size, r_y * per_size
    slip = size - even * stress
    to_x, to_y = slip + compliance * lean * stress, slip + compliance * stress
    d_x, d_y = r_x * to_x, r_y * to_y
    per_length = 1.0 / (np.sqrt(d_x * d_x + d_y * d_y) + NO_SLIP)
    n_x, n_y = d_x * per_length, d_y * per_length
    # By both parts of the reach: of c_e, of T (by c_e it falls as T dT/d|r|), and of g.
    even_x = even * per_size * e_x * (1.0 - square)
    even_y = even * per_size * e_y * (1.0 - square / (lean * lean))
    t_x, t_y = slope * (e_x - stress * even_x), slope * (e_y - stress * even_y)
    g_x, g_y = e_x - even * t_x - stress * even_x, e_y - even * t_y - stress * even_y
    bends = stress * per_length
    a_x = bends * (n_x * r_y * (g_x + compliance * t_x) - n_y * (to_x + r_x * (g_x + compliance * lean * t_x)))
    a_y = bends * (n_x * (to_y + r_y * (g_y + compliance * t_y)) - n_y * r_x * (g_y + compliance * lean * t_y))
    slopes = n_x * t_x - n_y * a_x, n_x * t_y - n_y * a_y, n_y * t_x + n_x * a_x, n_y * t_y + n_x * a_y
    return stress * n_x, stress * n_y, slopes


@entry(
    lambda: {"contact": CONTACT_STATE, "flow": (float, float, float), "quadrature": QUADRATURE, "flows": 3, "state": 1},
    fastmath=FAST,
)
def march_strips(contact, flow, quadrature, flows, state):
    """All strips, marched side by side from their leading edges; writes their forces, stiffness and friction.

    flow : its direction, L u along, and L across over L along
    flows : (nodes, 3, strips) of `flow_at`;  state : (ROWS * PITCH,) numbers, with slip along, across and by spin
    Nodes of different strips do not wait for each other, as those of one strip do. Where nothing is decided a processor
    takes several at once, as the compiler knows how far apart the rows are.
    """
    side, length, lean = flow
    stiffer = 1.0 / (lean * lean)
    sines, cosines, weights = quadrature.along[0], quadrature.along[1], quadrature.along[2]
    peak, across = peak_pressure(contact), quadrature.across[1]
    for j in range(quadrature.strips):
        state[HALF + j] = contact.semi_axis_rolling * across[j]
        state[PER_STEP + j] = length / state[HALF + j]
    for k in range(quadrature.nodes):
        place = side * sines[k]
        halfway = place if k > 0 else side * (sines[0] - 1.0) / 2.0  # from the edge
        to_here, to_last, to_older = quadrature.steps[0, k], quadrature.steps[1, k], quadrature.steps[2, k]
        for j in range(quadrature.strips):
            from_last, from_older = state[PER_STEP + j] * to_last, state[PER_STEP + j] * to_older
            last_x, last_y = state[STRESS_X + j], state[STRESS_Y + j]
            reach_x = state[SLIDE + j] + from_last * last_x - from_older * state[OLDER_X + j]
            reach_y = state[LATERAL + j] + state[SPIN + j] * halfway * state[HALF + j]
            reach_y += lean * (from_last * last_y - from_older * state[OLDER_Y + j])
            state[OLDER_X + j], state[OLDER_Y + j] = last_x, last_y
            state[REACH_X + j], state[REACH_Y + j] = reach_x, reach_y
            square_x, square_y = reach_x * reach_x + NO_SQUARE, reach_y * reach_y
            state[REACH + j] = np.sqrt(square_x + square_y)
            state[STIFFER + j] = np.sqrt((square_x + square_y) / (square_x + square_y * stiffer))
        if contact.own == 0.0:
            for j in range(quadrature.strips):
                shear = shear_at(contact, peak * across[j] * cosines[k], flows[k, 0, j], flows[k, 1, j], flows[k, 2, j])
                even = state[PER_STEP + j] * to_here * state[STIFFER + j]
                state[STRESS + j], state[SLOPE + j] = sheared(state[REACH + j], even, shear)
        else:
            _shear_by_own(contact, (peak * cosines[k], to_here), quadrature, flows[k], state)
        for j in range(quadrature.strips):
            soft, half, stress = state[PER_STEP + j], state[HALF + j], state[STRESS + j]
            reach, sizes = (state[REACH_X + j], state[REACH_Y + j]), (state[REACH + j], state[STIFFER + j])
            stress_x, stress_y, slopes = turned_stress(reach, sizes, stress, state[SLOPE + j], soft * to_here, lean)
            x, area = half * place, weights[k] * half * cosines[k]
            state[STRESS_X + j], state[STRESS_Y + j] = stress_x, stress_y
            state[FORCES + j] += area * stress_x
            state[FORCES + PITCH + j] += area * stress_y
            state[FORCES + 2 * PITCH + j] += area * stress_y * x
            state[ALL_FRICTION + j] += area * stress
            pulls = soft * to_last, soft * to_older, lean
            _respond(state, BY_SLIDE + j, (1.0, 0.0), pulls, slopes, (area, x))
            _respond(state, BY_LATERAL + j, (0.0, 1.0), pulls, slopes, (area, x))
            _respond(state, BY_SPIN + j, (0.0, halfway * half), pulls, slopes, (area, x))


@compiled
def _shear_by_own(contact, node, quadrature, flows, state):
    """Write stress and slope of all strips at a node by a user's law.

    node : pressure there on the middle strip, and how far its stress pulls the slip;  flows : (3, strips) of the node
    """
    for j in range(quadrature.strips):
        pressure = node[0] * quadrature.across[1, j]
        shear = shear_at(contact, pressure, flows[0, j], flows[1, j], flows[2, j])
        even = state[PER_STEP + j] * node[1] * state[STIFFER + j]
        state[STRESS + j], state[SLOPE + j] = sheared_by_own(state[REACH + j], even, shear, contact.own)


@compiled(fastmath=FAST)
def _respond(state, first, own, pulls, slopes, node):
    """Go on by a node with what one kind of slip does to the stress, and add it to the stiffness.

    first : of its rows in the state;  own : how it moves the node itself
    pulls : of the last nodes' stress along, and how much more they are across;  slopes : of `crept`
    node : area and place
    """
    area, x = node
    last_x, last_y = state[first], state[first + PITCH]
    to_x = own[0] + pulls[0] * last_x - pulls[1] * state[first + 2 * PITCH]
    to_y = own[1] + pulls[2] * (pulls[0] * last_y - pulls[1] * state[first + 3 * PITCH])
    by_x, by_y = slopes[0] * to_x + slopes[1] * to_y, slopes[2] * to_x + slopes[3] * to_y
    state[first], state[first + PITCH] = by_x, by_y
    state[first + 2 * PITCH], state[first + 3 * PITCH] = last_x, last_y
    state[first + 4 * PITCH] += area * by_x
    state[first + 5 * PITCH] += area * by_y
    state[first + 6 * PITCH] += area * by_y * x


@compiled
def clear_strips(state, strips):
    """Begin the numbers of strips, for `march_strips`."""
    for row in range(ROWS):
        for j in range(strips):
            state[row * PITCH + j] = 0.0


@compiled
def marched_strip(state, j):
    """Forces and stiffness by slip along a strip, across it and by spin, and all friction."""
    slide, lateral, turn = BY_SLIDE + 4 * PITCH + j, BY_LATERAL + 4 * PITCH + j, BY_SPIN + 4 * PITCH + j
    stiffness = (
        state[slide],
        state[lateral],
        state[turn],
        state[slide + PITCH],
        state[lateral + PITCH],
        state[turn + PITCH],
        state[slide + 2 * PITCH],
        state[lateral + 2 * PITCH],
        state[turn + 2 * PITCH],
    )
    forces = (state[FORCES + j], state[FORCES + PITCH + j], state[FORCES + 2 * PITCH + j])
    return forces, stiffness, state[ALL_FRICTION + j]


@compiled
def shear_at(contact, pressure, eyring, fluidity, most):
    """The law at a node."""
    return Shear(contact.boundary * pressure + contact.plain, contact.limit * pressure, eyring, fluidity, most)


@compiled
def hold_flows(contact: Record, quadrature: Record, flows: Array) -> None:
    """Write (along, 3, across) the numbers of `flow_at` of the nodes, which do not change with the slip.

    The nodes lie in pairs about the middle of the ellipse, where the pressure is the same.
    """
    law = PointLaw(
        contact.boundary,
        contact.plain,
        contact.limit,
        contact.eyring,
        contact.fluidity,
        contact.share,
        contact.alpha,
        contact.bend,
        contact.exponent,
        contact.rises,
        contact.own,
    )
    strips, nodes = quadrature.across[1], quadrature.along[1]
    last_strip, last_node = quadrature.strips - 1, quadrature.nodes - 1
    peak = peak_pressure(contact)
    for j in range(last_strip // 2 + 1):
        for k in range(last_node // 2 + 1):
            flow = flow_at(law, peak * strips[j] * nodes[k])
            for each in range(3):
                flows[k, each, j] = flows[last_node - k, each, j] = flow[each]
                flows[k, each, last_strip - j] = flows[last_node - k, each, last_strip - j] = flow[each]


@compiled
def peak_pressure(contact: Record) -> float:
    """p0, Pa."""
    return 1.5 * contact.load / (np.pi * contact.semi_axis_rolling * contact.semi_axis_transverse)
