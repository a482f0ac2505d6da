"""Search at decision time (lesson 18)."""
