"""The comparison: production formulas against finite elements, with uncertainty, price and verdict."""
