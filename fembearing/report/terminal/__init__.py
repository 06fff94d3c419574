"""Results as tables of text for a terminal."""
