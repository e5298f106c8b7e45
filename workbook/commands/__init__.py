"""The work of the commands; each is loaded when it is called."""
