"""What the documentation adds to Sphinx: mathematics, citations, docstrings, and pages made from the tree."""
