"""A scene at many points: a product of axes, computed on all cores and gathered in one file; it survives a stop.

`grid` reads the axes, `parts` computes a piece of the points, `cluster` distributes the pieces over Dask workers,
`store` keeps the finished pieces, `dataset` gathers them, and `run` runs all of these.
"""
