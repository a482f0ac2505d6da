"""Goals (lesson 11)."""
