"""Training: the loops in which an agent meets a task, and `train`, which measures the learning curve."""
