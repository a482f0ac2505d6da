"""The environments, one challenge each."""
