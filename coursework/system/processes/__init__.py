"""Limits of time and memory, and watched processes that do jobs."""
