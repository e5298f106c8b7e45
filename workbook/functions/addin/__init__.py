"""The content of the LibreOffice add-in; runs in LibreOffice's own Python, 3.8 or newer, without NumPy."""
