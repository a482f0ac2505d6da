"""Profiles: which challenges an agent masters, and how strong each of them may become."""
