"""What other programs change in the folder, told to the browser as it happens.

Enters: a `Folder`.  Leaves: server-sent events, each with the files that there are.  Used by `files.py`.
"""

from __future__ import annotations

import asyncio
import json
from collections.abc import AsyncIterator

from watchfiles import awatch

from coursework.desk.serving.folder import SUFFIX, Folder

ALIVE = 15_000  # ms after which a browser hears that the line still stands
_SETTLED = 100  # ms in which changes are told together


async def events(folder: Folder) -> AsyncIterator[str]:
    """Yield the list of files now, and after each change of one."""
    yield "retry: 1000\n\n"
    told = ""
    watching = awatch(
        folder.path, watch_filter=lambda _, path: path.endswith((SUFFIX, ".csv")), debounce=_SETTLED, step=_SETTLED // 2,
        rust_timeout=ALIVE, yield_on_timeout=True, recursive=False,
    )  # fmt: skip
    change = None
    try:
        while True:
            change = asyncio.ensure_future(anext(watching))
            await asyncio.sleep(0)  # from here on nothing is missed
            files = json.dumps(await asyncio.to_thread(folder.listed))
            yield ":\n\n" if files == told else f"event: files\ndata: {files}\n\n"
            told = files
            await change
    finally:
        if change is not None:
            change.cancel()
