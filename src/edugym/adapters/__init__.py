"""The same MDP as a Gymnasium environment and as a vector environment."""
