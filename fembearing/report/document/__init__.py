"""The document of a report: what report.json holds, as typed models."""
