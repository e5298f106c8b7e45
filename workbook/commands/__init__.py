"""What the commands do; each is loaded when it is called."""
