"""The runs of a sentence as HTML: symbols in italics, raised powers, parts to keep on one line, typed text.

Enters: runs, as `report/text/text_runs.py` makes them; a text; a cell (either of these).  Leaves: escaped HTML.
Used by `templates.py`, which passes them to `reports/parts.html.j2`; a page calls them about a thousand times.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

from markupsafe import Markup, escape

from coursework.words.line_ends import line_groups

# The element around text to keep on one line: it has a short name and no meaning, and a page has two hundred of it.
_BEGIN, _END = "<bdi>", "</bdi>"
_FORMS = {"t": "{}", "o": '<span class="paper">{}</span>', "p": "<sup>{}</sup>"}


def said(runs: Sequence[dict[str, str]]) -> Markup:
    """Return runs as HTML; consecutive runs in another language than the page's share one element.

    >>> said([{"v": "φ", "s": "3"}, {"t": " is <small>"}, {"p": "2"}])
    Markup('<i>φ</i><sub>3</sub> is &lt;small&gt;<sup>2</sup>')
    >>> said([{"c": "w1 = 2"}, {"t": " in row 3"}])
    Markup('<bdi>w1 = 2</bdi> in <bdi>row 3</bdi>')
    """
    groups = line_groups(runs)
    return Markup("".join(f"{_BEGIN}{_written(group, kept)}{_END}" if kept else _written(group, kept) for kept, group in groups))


@lru_cache(maxsize=4096)
def said_text(text: str) -> Markup:
    """Return a text as HTML."""
    return said([{"t": text}])


def said_cell(content: str | Sequence[dict[str, str]]) -> Markup:
    """Return a cell as HTML."""
    return said_text(content) if isinstance(content, str) else said(content)


def _written(runs: Sequence[dict[str, str]], kept: bool) -> str:
    parts = []
    foreign = None
    for run in runs:
        language = run.get("lang")
        if foreign is not None and language is None:
            parts.append("</span>")
        elif foreign is None and language is not None:
            parts.append(f'<span lang="{escape(language)}">')
        foreign = language
        parts.append(_one(run, kept))
    if foreign is not None:
        parts.append("</span>")
    return "".join(parts)


def _one(run: dict[str, str], kept: bool) -> str:
    for key, form in _FORMS.items():
        if key in run:
            return form.format(escape(run[key]))
    if "c" in run:
        typed = escape(run["c"])
        return typed if kept else f"{_BEGIN}{typed}{_END}"
    letter = f"<i>{escape(run['v'])}</i>"
    if not (low := run.get("s")):
        return letter
    kind = "<sub>" if low.isdigit() else '<sub class="v">'
    return f"{letter}{kind}{escape(low)}</sub>"
