"""What the functions MOTION.* compute, with ``math`` alone; knows no spreadsheet."""
