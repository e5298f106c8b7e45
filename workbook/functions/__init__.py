"""The functions for an engineer's own sheets: declared once, computed by Excel names and by a LibreOffice add-in."""
