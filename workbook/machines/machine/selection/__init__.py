"""Motor and reducer of a drive from catalogues: entries, and the pair in use."""
