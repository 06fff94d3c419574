"""The HTML page of a report, made from the document."""
