"""Controllers' cam tables: what each takes, how its file is written, and an independent reader of it."""
