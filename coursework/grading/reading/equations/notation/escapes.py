r"""What programs put into and around a text when they export it: \n for an end of line, quotation marks with a key before them.

Enters: a text or a line as decoded.  Leaves: the text with ends of lines, the line without the marks.  Nothing is run.
Used by `text_lines.py`.
"""

from __future__ import annotations

import re

from coursework.grading.reading.equations.notation.signs import relates_two_sides

_END = r"(?<!\\)(?:\\r)?\\n"
# Among commands of LaTeX: there \nu, \ne, \ni and each n before two small letters, or before an arrow, begin a command.
_LINE_END = re.compile(rf"{_END}(?![eiu](?![A-Za-z])|[a-z]{{2}}|Right|Left|V[dD]a)")
_BEFORE_U = re.compile(rf"(?<=[\w)}}\]]){_END}(?=u\s*[-+=])")  # no letter \nu among ends of lines
_WORDS = "icefrac|ewline|ewpage|onumber|otag|oindent|abla|ormalsize"
_ANY_LINE_END = re.compile(rf"(?:\\{{1,2}}r)?\\{{1,2}}n(?!(?:{_WORDS})(?![A-Za-z]))")
_OF_LATEX = re.compile(r"\\(?!r?\\?n|[rt](?![A-Za-z]))[A-Za-z]|\\(?:newcommand|def)\b|\\\\\s|\\$", re.MULTILINE)
_PRINTED = re.compile(r"\\n[\"']\s*,\s*\w")  # printf("w3 = %f\n", w3)
_QUOTED = re.compile(r"(?<!\w)([\"'])((?:(?!\1).)*)\1(?=\s*(?:[,;\])}]|$))")
_AROUND = re.compile(r"[\s\w.:=>,;\[\]{}\"'-]*")  # keys and brackets of lists
_TAGGED = re.compile(r"\s*<(\w{1,20})\b[^<>]{0,80}>(.*)</\1>\s*")  # in XML
_SHOWN = re.compile(r"\s*(?:print|disp|puts|display)\s*\(?\s*([\"'])((?:(?!\1)[^{%])*)\1\s*\)?\s*;?")  # print("a = b")
_PAIR = re.compile(r"([\"'])([^\W\d]\w{0,9})\1\s*:\s*(?:([\"'])((?:(?!\3).)*)\3|(?=[^\"'\s]))")  # 'w3': 'a*b' of a dictionary
_QUOTES = '"“”„«»`'
_KEY = re.compile(r"\s*(?:-\s+)?([^\W\d]\w{0,20})\s*[:=]\s*([\"'])([^\"'\n]*(?:sin|cos)\b[^\"'\n]*)\2\s*,?\s*")


def with_line_ends(text: str) -> tuple[str, list[int]]:
    r"""Return a text with its ends of lines that are written as \n, and for each line the number of the line it stood in.

    >>> with_line_ends(r"a = 0\nnu = 1" + "\nb = 2")
    ('a = 0\nnu = 1\nb = 2', [1, 1, 2])
    >>> with_line_ends(r"\nu = r\omega\nv = \nu")[0], with_line_ends("a = 0")
    ('\\nu = r\\omega\nv = \\nu', ('a = 0', []))
    """
    if "\\n" not in text:
        return text, []
    if not _OF_LATEX.search(text):
        ends = _ANY_LINE_END
    elif _LINE_END.search(text):
        ends, text = _LINE_END, _BEFORE_U.sub(r"\\n ", text)
    else:
        return text, []
    lines = text.split("\n")
    lines = [line if _PRINTED.search(line) or not ends.search(line) else ends.sub("\n", unquoted(line)) for line in lines]
    numbers = [number for number, line in enumerate(lines, start=1) for _ in range(line.count("\n") + 1)]
    return "\n".join(lines), numbers


def unquoted(line: str) -> str:
    """Return a line without the quotation marks of its equations and the keys before these, as JSON, YAML and TOML have them.

    >>> unquoted('- eq1: "a = b"'), unquoted("eqs = ['a = b', 'c = d']"), unquoted('"a" + "b" = c'), unquoted('w3: "V/sin(f)",')
    ('a = b', 'a = b; c = d', 'a" + "b" = c', 'w3 = V/sin(f)')
    """
    if '_"' in line:  # V_"Mx" has an index in Typst
        return line
    if "<" in line and (tagged := _TAGGED.fullmatch(line)) and relates_two_sides(tagged[2]):
        line = tagged[2]
    if '"' in line or "'" in line:
        line = printed[2] if (printed := _SHOWN.fullmatch(line)) and relates_two_sides(printed[2]) else line
        quoted = [found[2] for found in _QUOTED.finditer(line) if relates_two_sides(found[2])]
        if quoted and _AROUND.fullmatch(_QUOTED.sub("", line)):
            return "; ".join(quoted)
        line = _PAIR.sub(lambda found: f"{found[2]} = {found[4] or ''}", _KEY.sub(r"\1 = \3", line))
    return line.strip(_QUOTES + " ,")
