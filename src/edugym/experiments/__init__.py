"""Training, repetition and the experiments of the paper."""
