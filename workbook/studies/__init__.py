"""Studies: many designs of one machine, told by what varies, what is asked of them, and what is best."""
