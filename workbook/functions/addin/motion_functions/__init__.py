"""The computation of the functions MOTION.*, with ``math`` alone; knows no spreadsheet."""
