"""pycel as a witness: each shape of formula compiled once, cells in an order sought without recursion."""
