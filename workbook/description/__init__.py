"""The content of a machine description: its keys, as a page, a JSON Schema, and a description with comments."""
