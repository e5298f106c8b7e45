"""The sheets of flying machining."""
