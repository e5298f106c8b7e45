"""The sheets, one a file: each function declares what stands on its sheet, in the order an engineer reads it."""
