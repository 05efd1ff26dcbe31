"""Removes the rules of a page's stylesheet that nothing on the page needs.

Enters: a finished page.  Leaves: the page without rules for elements, classes, ids and attributes that do not occur in it.
Used by the report and by the pages of assigning and grading; not by the desk, whose pages change while shown.
"""

from __future__ import annotations

import re
from collections.abc import Container

_SHEET = re.compile(r"(?<=<style>).*?(?=</style>)", re.DOTALL)
_SCRIPT = re.compile(r"<script.*?</script>", re.DOTALL)
_NAME = re.compile(r"[\w-]+")
_RULE = re.compile(r"([^{};]+)\{([^{}]*)\}")
_NESTED = re.compile(r"(?<=[{}])[^{};,]*:has\(\.([\w-]+)\)\s*\{(?:[^{}]|\{[^{}]*\})*\}")  # rules about what holds a class
_PAGE = re.compile(r"@page (\w+)\s*\{[^{}]*\}")
_EMPTY = re.compile(r"@media[^{}]*\{\s*\}")
_VARIABLE = re.compile(r"(--[\w-]+):[^;{}]*;")
_COMMA = re.compile(r"([(),])")
_CHOICE = re.compile(r":(?:is|where)\(([^()]*)\)")
_LANGUAGE = re.compile(r":lang\((\w+)\)")
_BRACKETS = re.compile(r"\([^()]*\)")
_ASKED = re.compile(r"""[.#](?P<name>[\w-]+)|\[(?P<attribute>[\w-]+(?:="[^"]*")?)\]|(?<![\w.#:\["=-])(?P<tag>[a-z]\w*)""")


def fitted(page: str) -> str:
    """Return a page with only those rules of its stylesheet that may apply to it, and the variables used in them.

    >>> fitted('<style>.a{top:0}.b,h1{top:1px}@media print{.c{top:2px}}</style><p class="b">')
    '<style>.b{top:1px}</style><p class="b">'
    """
    sheet = _SHEET.search(page)
    if sheet is None:
        return page
    rest = page[: sheet.start()] + page[sheet.end() :]
    # A script may create any element and set any class that it names.
    made = {word for script in _SCRIPT.findall(rest) for word in _NAME.findall(script)}
    found: dict[str, Container[str]] = {
        "attribute": rest,
        "name": made | {name for names in re.findall(r' (?:class|id)="([^"]*)"', rest) for name in names.split()},
        "tag": made | set(re.findall(r"<([a-z]\w*)", rest)),
    }

    def concerns(selector: str) -> bool:
        while choice := _CHOICE.search(selector):
            if not any(map(concerns, choice[1].split(","))):
                return False
            selector = selector.replace(choice[0], "")
        if any(f'lang="{language}' not in rest for language in _LANGUAGE.findall(selector)):
            return False
        while (plain := _BRACKETS.sub("", selector)) != selector:
            selector = plain
        asked = ((one.lastgroup or "", one[0].strip(".#[]")) for one in _ASKED.finditer(selector))
        return all(name in found[kind] for kind, name in asked)

    def kept(rule: re.Match[str]) -> str:
        selectors = [one for one in _listed(rule[1]) if one.lstrip().startswith("@") or concerns(one)]
        return f"{','.join(selectors)}{{{rule[2]}}}" if selectors else ""

    held = _NESTED.sub(lambda rule: rule[0] if rule[1] in found["name"] else "", sheet[0])
    fit = _EMPTY.sub("", _RULE.sub(kept, held))
    fit = _PAGE.sub(lambda one: one[0] if re.search(rf"page:\s*{one[1]}\b", fit) else "", fit)
    fit = _VARIABLE.sub(lambda one: one[0] if f"var({one[1]}" in fit or f"var({one[1]}" in rest else "", fit)
    return page[: sheet.start()] + fit + page[sheet.end() :]


def _listed(selectors: str) -> list[str]:
    """Return the selectors of a list; brackets in them may contain lists again."""
    found, depth = [""], 0
    for piece in _COMMA.split(selectors):
        depth += (piece == "(") - (piece == ")")
        if piece == "," and not depth:
            found.append("")
        else:
            found[-1] += piece
    return found
