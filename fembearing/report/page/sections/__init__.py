"""The sections of the page: each gives the template what it shows, from the document (report.json's content) alone."""
