"""The machines, a file each: the entries of its description beyond the laws, and the sheets of its book."""
