"""The amount of signal (lesson 6)."""
