"""The report: tables, plots and pictures of what the comparison gave, on a terminal, as HTML and as JSON.

Nothing is computed here that a reader could take for a result: numbers come from `fembearing.check`.
"""
