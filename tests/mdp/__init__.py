"""The core: what an MDP is turned into."""
