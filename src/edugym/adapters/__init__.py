"""An MDP as a Gymnasium environment, as a vector environment, or as a game to play; the names of the environments."""
