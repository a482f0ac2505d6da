"""Several objectives."""
