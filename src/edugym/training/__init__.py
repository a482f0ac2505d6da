"""Training: the loops in which an agent meets a task, learning curves, and repetition over seeds."""
