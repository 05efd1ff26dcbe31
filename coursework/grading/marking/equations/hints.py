"""What would make a wrong line right, or why a line could not be read.

Enters: nothing.  Leaves: `Hint`.  Used by `equations.py`.
"""

from __future__ import annotations

from typing import Any, Literal

from coursework.system.frozen import frozen
from coursework.words.errors import Fault


@frozen
class Hint:
    """What would make a wrong line right: `text` is the corrected line; `others` counts further single edits that also do.

    `column` is that of the line as handed in, which a document or a cell may show otherwise; `term` is what stands there.
    """

    kind: Literal["sign", "function", "name", "factor", "datum", "repaired", "reader"]
    column: int
    text: str
    others: int = 0
    fault: Fault | None = None
    term: str = ""

    def plain(self) -> dict[str, Any]:
        """Return the record as grades.json writes it; for a line that could not be read, with the code of the fault."""
        told = {"kind": self.kind, "column": self.column, "text": self.text, "others": self.others}
        return told if self.fault is None else told | {"code": self.fault.code, "values": self.fault.message.plain()}
