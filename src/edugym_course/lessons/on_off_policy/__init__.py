"""On- and off-policy learning (lesson 2)."""
