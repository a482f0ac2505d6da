"""Model-based learning (lesson 9)."""
