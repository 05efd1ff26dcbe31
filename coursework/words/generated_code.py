"""Code generated from a file of the package, compiled once an installation, as Python compiles the package's own modules.

Enters: the file, what makes Python or a value of its text, and of what else that is made.  Leaves: compiled code; the value.
Used by `sentences.py`, `templates.py` and `report/live/script.py`.

Compiled code is kept in the folder from which Python reads this module compiled, by the loader that reads it, and on its terms:
`PYTHONDONTWRITEBYTECODE` and `PYTHONPYCACHEPREFIX` hold for both, and where that folder cannot be written code is generated at
every start.  So nothing is executed from a place where the tool's own code could not be replaced as well.
"""

from __future__ import annotations

from collections.abc import Callable
from importlib.machinery import SourceFileLoader
from importlib.util import cache_from_source
from pathlib import Path
from types import CodeType
from typing import Any
from zlib import crc32

from coursework.words.data_folders import REPORTS, folder_of_package


def generated_code(file: Path, made: Callable[[str], str], of: str) -> CodeType:
    """Return the code that `made` generates from the text of `file` and from what `of` names, such as a version.

    Raises `OSError` if there is no such file, and what `made` raises.
    """
    code = _Loader(file, made, of).get_code(file.name)
    assert code is not None  # only a loader of compiled libraries returns None
    return code


def made_once(file: Path, made: Callable[[str], Any]) -> Any:
    """Return what `made` makes of the text of `file`, which JSON can write; of a file of the package it is made only once.

    It is made anew when the file or the module of `made` has changed.  Raises what `made` raises.
    """
    if folder_of_package(REPORTS) not in file.parents:  # an instructor's own piece
        return made(file.read_text(encoding="utf-8"))

    def as_code(text: str) -> str:
        import json

        return f"import json\nvalue = json.loads({json.dumps(made(text), ensure_ascii=False)!r})"  # compiled faster than a dict

    scope: dict[str, Any] = {}
    exec(generated_code(file, as_code, str(Path(made.__code__.co_filename).stat().st_mtime_ns)), scope)
    return scope["value"]


class _Loader(SourceFileLoader):
    def __init__(self, file: Path, made: Callable[[str], str], of: str) -> None:
        super().__init__(file.name, str(file))
        self._made, self._of = made, of

    def path_stats(self, path: str) -> dict[str, Any]:
        """Return size and time of the file; in place of the time, which Python only compares, a number of it and `of`."""
        stats = super().path_stats(path)
        return {**stats, "mtime": crc32(f"{stats['mtime']} {self._of}".encode())}

    def get_data(self, path: str) -> bytes:
        """Return the content of the file, or the code that was kept, for which Python asks first."""
        return super().get_data(path if path == self.path else self._kept())

    def set_data(self, path: str, data: Any, **how: Any) -> None:
        """Keep code, or do without if the folder cannot be written."""
        super().set_data(self._kept(), data, **how)

    def _kept(self) -> str:
        own = Path(__file__)
        return cache_from_source(str(own.with_name(f"{own.stem}-{self.name}-{crc32(self.path.encode()):08x}.py")))

    def source_to_code(self, data: Any, path: Any, *_: Any, **how: Any) -> CodeType:  # type: ignore[override]  # static in an ABC
        """Return the code generated from the content of the file."""
        return super().source_to_code(self._made(data.decode("utf-8").replace("\r\n", "\n")), path, **how)
