"""Several agents (lesson 13)."""
