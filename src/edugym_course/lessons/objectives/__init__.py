"""Several objectives (lesson 12)."""
