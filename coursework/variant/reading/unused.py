"""Laws of [drive] that move nothing.

Enters: the `Source` of a file and the names it declares.  Leaves: faults.  Used by `reader.py` only.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

from coursework.variant.reading.names import Names
from coursework.variant.toml.source import Source
from coursework.words.errors import Fault
from coursework.words.sentences import say

_WORD = re.compile(r"[^\W\d]\w*")


def faults_of_unused_drives(source: Source, names: Names) -> list[Fault]:
    """Return a fault for each drive where none is a rate or stands anywhere: an acceleration, say, or a name mistyped.

    One that is left over beside others harms nobody.
    """
    used = {names.canonical(word) for text in _texts(source.data) for word in _WORD.findall(text)}
    driven = source.data.get("closure", {}).get("driven", "")
    used |= {names.canonical(f"V{driven}{axis}") for axis in "xy"}
    laws = source.data.get("drive", {})
    rate = next((entry["rate"] for entry in source.data["coordinates"].values()), "w1")
    idle = [law for law in laws if names.canonical(law) not in used]
    shown = idle if len(idle) == len(laws) else []
    return [source.fault(("drive", law), say("fault.V162", name=law, rate=rate), at_key=True) for law in shown]


def _texts(value: Any) -> Iterator[str]:
    """Yield every text that stands behind a key."""
    if isinstance(value, str):
        yield value
    elif isinstance(value, (dict, list)):
        for inner in value.values() if isinstance(value, dict) else value:
            yield from _texts(inner)
