"""Mechanisms that are in no file of the catalogue: a shaper, a five-bar with two drives, a boom on a cylinder, a six-bar."""

from __future__ import annotations

from tests.mechanisms.library import mechanism

SHAPER = mechanism("shaper")
FIVE_BAR = mechanism("five-bar")
BOOM = mechanism("boom")
STEPHENSON = mechanism("coupler-point")
