"""The loop (lesson 0)."""
