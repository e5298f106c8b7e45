"""Phases that hand velocity over: what their neighbours ask of them, and how their laws are carried out."""
