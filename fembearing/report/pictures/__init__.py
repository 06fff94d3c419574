"""Pictures of contacts and cages, made without a screen."""
