"""What every environment of the registry has to keep."""
