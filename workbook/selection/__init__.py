"""What machines with a sheet Selection share: its entries, the engine's view of them, its variations."""
