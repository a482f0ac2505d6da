"""Each environment against its paper."""
