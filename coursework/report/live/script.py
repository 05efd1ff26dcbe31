"""The one script of a page: the runtime of `reports/live` around the generated functions, and the hash that admits it.

Enters: JavaScript of the generated functions; data for JSON.  Leaves: text, the same bytes on every run.
Used by the live page, the page around it and the test that runs every variant of the catalogue in a browser.
"""

from __future__ import annotations

import base64
import hashlib
import json
import re
import zlib
from collections.abc import Mapping, Sequence
from functools import lru_cache
from itertools import product
from pathlib import Path
from string import ascii_letters
from typing import Any

from coursework.words.data_folders import folder
from coursework.words.generated_code import made_once

_TYPES = re.compile(r"/\*\* .*? \*/ ?")  # comments for a type checker
_TEXT = re.compile(r"""("(?:[^"\\\n]|\\.)*"|`[^`\n]*`)""")
# Line breaks that end no statement, and the semicolon after the last statement of a block; no loop of ours has an empty body.
# Each alternative begins with a character of its own, so that a search looks at no others.
_NEEDLESS = re.compile(r";\n(?=})|\n(?=[})\]])|\n(?<=[;{,(\[]\n)")
_SIGN = r"[-=+*/<>?:,;{}()\[\]&|!]"
_BESIDE = re.compile(rf" (?={_SIGN})|(?<={_SIGN}) ")
# Names in generated functions; words of the language that no name may be; successive lines of constants.
_WORD = re.compile(r"(?<![\w.])[A-Za-z_]\w*")
_KEPT = ("do", "if", "in", "of", "as", "const", "return")
_TOGETHER = re.compile(r"(?:^const [^\n]*;\n)+(?!const)", re.MULTILINE)
_READING = 'const data = JSON.parse(document.getElementById("coursework").textContent);'
_NO_CODE = re.compile(r"^\s*/[/*].*\n|^\s+|[ \t]+$", re.MULTILINE)  # comment lines, and white space at both ends of lines


def script_of(functions: str, pieces: Sequence[str]) -> str:
    """Return the script: reading of `data`, the first of the named pieces of the runtime, `functions`, the other pieces.

    Everything stands inside one function, so that the script defines no global name.
    """
    return _whole(functions, tuple(map(_piece, pieces)))


@lru_cache(maxsize=16)  # it contains no data: a page with other data has the same script
def _whole(functions: str, pieces: tuple[str, ...]) -> str:
    first, *others = pieces
    functions = _tight(functions)
    whole = "\n".join(("(() => {", '"use strict";', _READING, first, functions, *others, "})();"))
    return _NEEDLESS.sub("", whole)


def with_own(script: str, own: Mapping[str, Any]) -> str:
    """Return a script that adds `own` to the data of the page: data of every such page, which are packed with the script."""
    return script.replace(_READING, f"{_READING}Object.assign(data,{embedded(own)});", 1)


def shortened(functions: str) -> str:
    r"""Return generated functions with short names for their constants, and one `const` for successive constants.

    >>> print(shortened("const f = (t, out) => {\nconst k0 = sin(t);\nconst k1 = 2*k0;\nout[0] = k1;\nreturn out;\n};"))
    const f = (t, out) => {
    const a = sin(t),
    b = 2*a;
    out[0] = b;
    return out;
    };
    """
    taken = {*_WORD.findall(functions), *_KEPT}
    short = [name for size in (1, 2) for name in map("".join, product(ascii_letters, repeat=size)) if name not in taken]
    written, known, inside = list[str](), dict[str, str](), False
    for line in functions.split("\n"):
        if line.endswith("=> {") or line == "};":
            known, inside = {}, line != "};"
        elif inside and line.startswith("const "):
            kept = _WORD.findall(line.partition(" = ")[0].removeprefix("const "))
            known |= dict(zip(kept, short[len(known) :], strict=False))
        written.append(_renamed(line, known))
    return _TOGETHER.sub(lambda lines: lines[0].replace(";\nconst ", ",\n"), "\n".join(written))


def _renamed(line: str, known: Mapping[str, str]) -> str:
    return _WORD.sub(lambda word: known.get(word[0], word[0]), line)


@lru_cache(maxsize=16)
def packed(script: str) -> str:
    """Return a script in half the bytes, which unpacks the given one and runs it; that one needs its own hash as before."""
    deflated = zlib.compressobj(wbits=-zlib.MAX_WBITS)
    text = base64.b64encode(deflated.compress(script.encode("utf-8")) + deflated.flush()).decode("ascii")
    return _NEEDLESS.sub("", f'(() => {{\nconst packed="{text}";\n{_piece("unpacking")}\n}})();')


@lru_cache
def alone(name: str) -> str:
    """Return a script of `reports/` that needs nothing of the live part."""
    return f"(() => {{{_NEEDLESS.sub('', _text(folder('reports') / f'{name}.js'))}}})();"


def embedded(data: Mapping[str, Any]) -> str:
    r"""Return data as JSON that may stand inside a script element: keys in order, shortest numbers, no end tag.

    >>> embedded({"b": 0.1, "a": "</script>"})
    '{"a":"<\\/script>","b":0.1}'
    """
    text = json.dumps(data, sort_keys=True, ensure_ascii=False, allow_nan=False, separators=(",", ":"))
    return text.replace("</", "<\\/").replace("<!--", "<\\u0021--")


def hash_of(script: str) -> str:
    """Return the name of a script in a content security policy: the hash of exactly its bytes."""
    return "sha256-" + base64.b64encode(hashlib.sha256(script.encode("utf-8")).digest()).decode("ascii")


def _piece(name: str) -> str:
    """Return a file of the runtime without comment lines and indentation."""
    return _text(folder("reports") / "live" / f"{name}.js")


@lru_cache
def _text(path: Path) -> str:
    return str(made_once(path, _bare))


def _bare(text: str) -> str:
    return _tight(_NO_CODE.sub("", _TYPES.sub("", text)).strip())


def _tight(code: str) -> str:
    """Return code without the spaces beside operators; its string literals are unchanged."""
    parts = _TEXT.split(code)
    return "".join(part if place % 2 else _BESIDE.sub("", part) for place, part in enumerate(parts))
