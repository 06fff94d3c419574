"""The sections of documents: what is said of each topic, for terminal and page."""
