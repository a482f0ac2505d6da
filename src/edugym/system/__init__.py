"""What every program needs of the system: files, interrupts, memory, optional libraries."""
