"""Template (lesson 99)."""
