"""Carreau's law of shear thinning, tau = eta gamma [1 + (eta gamma/G)^2]^((n - 1)/2), with the exponent of squalane.

The scene gives G as `eyring_stress`: the law is tau = G f(x) with x = eta gamma/G. n = 0.463 and G = 6.94 MPa are those
of squalane in S. Bair, P. Vergne, M. Querry, Tribology Letters 18 (2005) 145-152, quoted from memory.
"""

EXPONENT = 0.463  # n


def stress(rate: float) -> float:
    """f(x), shear stress over G; rate : x, Newtonian shear stress over G"""
    return rate * (1 + rate**2) ** ((EXPONENT - 1) / 2)
