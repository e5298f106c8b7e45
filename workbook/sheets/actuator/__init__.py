"""The sheets of an actuator."""
