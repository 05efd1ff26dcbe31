"""The elements of one formula, OMML or MathML, as a small tree.

Enters: elements of an XML stream.  Leaves: `FormulaNode`; a formula that is too large or too deep ends in "…", which no reader
accepts as an equation.  Used by `docx.py`, `odt.py`, `rtf.py` and by what turns a tree into text.
"""

from __future__ import annotations

from dataclasses import dataclass, field

_MOST_NODES, _DEEPEST, _MOST_CHARACTERS = 4000, 50, 8000
CUT = "…"


@dataclass(slots=True)
class FormulaNode:
    """One element: its name, its attributes by name, its children and texts in their order."""

    name: str
    values: dict[str, str] = field(default_factory=dict)
    inside: list[FormulaNode | str] = field(default_factory=list)

    def child(self, name: str) -> FormulaNode | None:
        """Return the first child with this name, None if there is none."""
        return next((part for part in self.inside if isinstance(part, FormulaNode) and part.name == name), None)

    @property
    def children(self) -> list[FormulaNode]:
        """Return the child elements, without texts."""
        return [part for part in self.inside if isinstance(part, FormulaNode)]


class FormulaTree:
    """Builds one formula; `top` is its root."""

    def __init__(self, name: str) -> None:
        self.top = FormulaNode(name)
        self._open = [self.top]
        self._nodes = self._characters = 0
        self._too_deep = 0

    def begin(self, name: str, attributes: dict[str, str]) -> None:
        """Begin an element."""
        self._nodes += 1
        if self._too_deep or len(self._open) > _DEEPEST or self._nodes > _MOST_NODES:
            self._too_deep += 1
            self._cut()
            return
        node = FormulaNode(name, attributes)
        self._open[-1].inside.append(node)
        self._open.append(node)

    def end(self, name: str = "") -> None:
        """End the open element."""
        if self._too_deep:
            self._too_deep -= 1
        elif len(self._open) > 1:
            self._open.pop()

    def text(self, text: str) -> None:
        """Add text to the open element."""
        self._characters += len(text)
        if self._characters <= _MOST_CHARACTERS:
            self._open[-1].inside.append(text)
        else:
            self._cut()

    def value(self, text: str) -> None:
        """Set the value of the open element, for formats that give it as text."""
        self._open[-1].values["val"] = text[:4]

    def _cut(self) -> None:
        if self.top.inside[-1:] != [CUT]:
            self.top.inside.append(CUT)
