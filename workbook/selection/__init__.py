"""The shared parts of machines with a sheet Selection: its entries, the engine's view of them, its variations."""
