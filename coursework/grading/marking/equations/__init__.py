"""Velocity equations as students write them: right in any form, or wrong, with the slip named."""
