"""The textbook's agents, one file each."""
