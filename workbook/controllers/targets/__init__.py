"""The targets: a small module each, named in the register."""
