"""The exact model of a finite MDP, and planning on it: the optimum that learning is compared with."""
