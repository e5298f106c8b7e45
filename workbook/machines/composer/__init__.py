"""Composed motion (S3)."""
