"""The page of `fembearing app`: a torque that follows its inputs. It computes nothing by itself.

The text of the scene is the state of a page, and each browser tab has its own. One thread computes for all of them,
because the compiled functions use all cores; finite elements run in a process of their own.
"""
