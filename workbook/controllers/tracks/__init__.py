"""Writers and readers of switches, a file for each target that takes them."""
