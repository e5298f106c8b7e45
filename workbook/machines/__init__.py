"""The machines, one a file: what its description holds beyond the laws, and which sheets make up its book."""
