"""Reads back what the report wrote: equations as numbers, HTML and PDF as text."""

from __future__ import annotations

import math
import re
import unicodedata
from collections import Counter
from html.parser import HTMLParser
from typing import Any

from coursework.report.text.symbols import symbol

RAISED = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")
FUNCTIONS = {
    "sin": math.sin, "cos": math.cos, "tan": math.tan, "arcsin": math.asin, "arccos": math.acos, "arctan": math.atan,
    "exp": math.exp, "ln": math.log, "abs": abs, "√": math.sqrt, "sqrt": math.sqrt, "atan2": math.atan2,
    "frac": lambda above, below: above / below,
}  # fmt: skip


def value_of(source: str, values: dict[str, float], *, typst: bool) -> float:
    """Return the number an equation's text (or Typst source) stands for, read as a reader would."""
    return _Reader(source, values, typst).whole()


class _Reader:
    def __init__(self, source: str, values: dict[str, float], typst: bool) -> None:
        self.values = values
        names = {(symbol(name).typst if typst else symbol(name).text): name for name in values}
        self.names = names
        words = sorted([*names, *FUNCTIONS, 'op("atan2")', "dot", "slash", "thin"], key=len, reverse=True)
        pattern = r"\s*(?:(\d+(?:\.\d+)?)|(" + "|".join(map(re.escape, words)) + r")|([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)|([-−+·/^(),√]))"
        self.tokens: list[tuple[str, str]] = []
        at = 0
        while source[at:].strip():
            match = re.compile(pattern).match(source, at)
            assert match, f"cannot read {source[at:]!r} in {source!r}"
            number, word, raised, sign = match.groups()
            if word and word != "thin":
                word = {"dot": "·", "slash": "/", 'op("atan2")': "atan2"}.get(word, word)
                self.tokens.append(("sign" if word in "·/" else "function" if word in FUNCTIONS else "name", word))
            elif number:
                self.tokens.append(("number", number))
            elif raised:
                self.tokens.append(("raised", raised.translate(RAISED)))
            elif sign:
                sign = sign.replace("−", "-")
                self.tokens.append(("function", sign) if sign == "√" else ("sign", sign))
            at = match.end()
        self.at = 0

    def peek(self) -> tuple[str, str]:
        return self.tokens[self.at] if self.at < len(self.tokens) else ("end", "")

    def take(self, text: str) -> bool:
        if self.peek() == ("sign", text):
            self.at += 1
            return True
        return False

    def whole(self) -> float:
        value = self.sum()
        assert self.peek()[0] == "end", f"left over: {self.tokens[self.at :]}"
        return value

    def sum(self) -> float:
        value = -self.quotient() if self.take("-") else self.quotient()
        while self.peek() in {("sign", "+"), ("sign", "-")}:
            minus = self.take("-") or not self.take("+")
            value += -self.quotient() if minus else self.quotient()
        return value

    def quotient(self) -> float:
        value = self.product()
        if self.take("/"):
            value /= self.factor()
            assert self.peek() != ("sign", "/"), "two slashes in a row mean two things"
        return value

    def product(self) -> float:
        value = self.factor()
        while self.take("·") or self.peek()[0] in {"number", "name", "function"} or self.peek() == ("sign", "("):
            value *= self.factor()
        return value

    def factor(self) -> float:
        kind, text = self.peek()
        if kind == "function":
            self.at += 1
            power = self.exponent()
            value = FUNCTIONS[text](*self.arguments())
            return self.raised(value**power)
        self.at += 1
        if (kind, text) == ("sign", "("):
            value = self.sum()
            assert self.take(")")
        elif kind == "number":
            value = float(text)
            assert self.peek()[0] != "number", "two numbers in a row read as one"
        else:
            assert kind == "name", f"unexpected {text!r}"
            value = self.values[self.names[text]]
        return self.raised(value)

    def raised(self, value: float) -> float:
        power = self.exponent()
        return value if power == 1.0 else value**power

    def exponent(self) -> float:
        if self.peek()[0] == "raised":
            self.at += 1
            return float(self.tokens[self.at - 1][1])
        if self.take("^"):
            assert self.take("(")
            power = self.sum()
            assert self.take(")")
            return power
        return 1.0

    def arguments(self) -> list[float]:
        if self.take("("):
            found = [self.sum()]
            while self.take(","):
                found.append(self.sum())
            assert self.take(")")
            return found
        kind, text = self.peek()
        assert kind == "name", "without parentheses a function takes a single symbol"
        self.at += 1
        return [self.values[self.names[text]]]


class _Text(HTMLParser):
    """Collects what a reader sees; of pictures the words."""

    BREAKS = frozenset({"td", "th", "p", "div", "li", "dt", "dd", "h1", "h2", "tr", "figcaption", "span", "br", "text", "table"})

    def __init__(self) -> None:
        super().__init__(convert_charrefs=True)
        self.parts: list[str] = []
        self.hidden = 0
        self.lettered = 0

    def handle_starttag(self, tag: str, attrs: Any) -> None:
        self.hidden += tag in {"svg", "style", "title", "script"}
        self.lettered += tag == "text"
        if ("role", "math") in attrs:  # a drawn formula is read by its label
            self.parts.append(f" {dict(attrs)['aria-label']} ")
        self.parts += [" "] if tag in self.BREAKS else []

    def handle_endtag(self, tag: str) -> None:
        self.hidden -= tag in {"svg", "style", "title", "script"}
        self.lettered -= tag == "text"
        self.parts += [" "] if tag in self.BREAKS else []

    def handle_data(self, data: str) -> None:
        if not self.hidden or self.lettered:
            self.parts.append(data)


def html_text(page: str) -> str:
    """Return the text of an HTML page, normalised."""
    reader = _Text()
    reader.feed(page)
    return normal("".join(reader.parts))


def pdf_text(page: bytes) -> str:
    """Return the text of a PDF, normalised."""
    import pymupdf

    with pymupdf.open(stream=page, filetype="pdf") as document:
        return normal("\n".join(sheet.get_text() for sheet in document))


def normal(text: str) -> str:
    """Return text without the differences that are none: spaces, mathematical letters, places to break."""
    return re.sub(r"\s+", " ", unicodedata.normalize("NFKC", text.replace("\u200b", "")).replace("-", "−"))


def numbers(text: str, decimals: int = 3) -> Counter[str]:
    """Return the numbers with at least so many decimals, counted (ticks of figures have fewer)."""
    text = re.sub(r"− (?=\d)", "−", text)  # a PDF has no space behind the minus of a sum
    return Counter(re.findall(rf"−?\d+\.\d{{{decimals},}}", text))
