"""A problem of one's own (lesson 10)."""
