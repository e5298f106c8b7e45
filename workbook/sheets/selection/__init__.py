"""The sheet Selection: motor and reducer from catalogues."""
