"""What a machine description may hold: its keys, as a page, a JSON Schema, and a description with comments."""
