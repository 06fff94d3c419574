"""One question at many points: a scene and axes, computed on all cores, kept as it goes, and gathered in one file.

`grid` reads what is asked, `parts` computes a piece of it, `workers` spreads the pieces over processes, `store` keeps
what is done, `run` does it all, and `dataset` gathers it.
"""
