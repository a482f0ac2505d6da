"""MDPs and environments that change what another one shows."""
