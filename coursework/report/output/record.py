"""The content of `run.json` and `accuracy.json`: how the numbers were computed, and which files belong together.

Enters: a `SceneRun`.  Leaves: plain data, and the stamp that ties pages, tables and record of one run together.
Used by `write.py`.
"""

from __future__ import annotations

import hashlib
import json
from dataclasses import asdict, fields
from math import isfinite
from typing import TYPE_CHECKING, Any

from coursework.scene.quantities import DYNAMICS, FORCES, Quantity, quantities_for
from coursework.scene.scene_run import SceneRun
from coursework.words.custom_templates import stamp_of_templates

if TYPE_CHECKING:
    from coursework.drawing.check_sheet.graph_check import GraphCheck
    from coursework.results.checks.result import Finding

STAMP_LENGTH = 16  # characters of the hash: enough that two runs never share it by chance, few enough to compare by eye


def stamp_of(run: SceneRun, language: str = "en") -> str:
    """Return the stamp of a run: a hash of its variant, options, templates and tool version, but not of the file's path."""
    named = (run.student, run.group, run.teacher, run.institution, run.date, run.blank)
    settings = (run.settings, run.asked, named, language, stamp_of_templates(), run.versions["coursework"])
    kept = {one.name: getattr(run.variant, one.name) for one in fields(run.variant) if one.repr} | {"path": None}
    said = ", ".join(f"{name}={value!r}" for name, value in kept.items())
    content = f"(Variant({said}), {settings!r})" + (repr(run.variant.forces) if run.variant.forces else "")
    return hashlib.sha256(content.encode("utf-8", "backslashreplace")).hexdigest()[:STAMP_LENGTH]


def record(run: SceneRun) -> dict[str, Any]:
    """Return the content of `run.json` without stamp and files: versions, scheme, stop, checks and more."""
    motion = run.motion
    checks = run.checks if "checks" in run.asked else ()
    return {
        "variant": run.variant.name,
        "title": run.variant.title,
        "set": run.variant.set_values,
        "versions": run.versions,
        "scheme": run.settings.scheme,
        "step": motion.step,
        "end": run.variant.time.end,
        "rows": len(motion.t),
        "evaluations": motion.evaluations,
        "quantities": list(run.asked),
        "columns": run.units,
        "contents": [_content(quantity) for quantity in quantities_for(run.asked).values()],
        "stop": None if run.stop is None else asdict(run.stop),
        "remarks": [
            {"code": remark.code, "line": remark.line, "sentence": str(remark.sentence)} for remark in run.variant.plausibility
        ],
        "summary": run.summary,
        "lesson": asdict(run.distance_to_exact) if run.distance_to_exact is not None else None,
        "checks": [_finding(check) for check in checks],
        **({"graph_check": _graph(run.graph_check)} if run.graph_check is not None else {}),
        **({"forces": _forces(run)} if run.asks(FORCES) else {}),
        **({"dynamics": _dynamics(run)} if run.asks(DYNAMICS) else {}),
    }


def _dynamics(run: SceneRun) -> dict[str, Any]:
    """Return the entry "regime": the steady motion of a crank that forces turn, or None if there is none."""
    regime = getattr(run.scene, "regime", None)
    return {"regime": None if regime is None else asdict(regime) | {"delta": regime.delta}}


def _forces(run: SceneRun) -> dict[str, Any]:
    from coursework.effects.told import force_record

    return force_record(run.of(FORCES), run.variant.time.period)


def _content(quantity: Quantity[Any]) -> dict[str, Any]:
    return {
        "name": quantity.name, "about": quantity.about, "shown": quantity.shows.kind, "needs": list(quantity.needs),
    }  # fmt: skip


def _graph(graph: GraphCheck) -> dict[str, Any]:
    """Return what was read off the drawing: values with their units, and the centre of each link (None if it translates)."""
    told = [{name: getattr(one, name) for name in ("name", "found", "read", "table", "unit")} for one in graph.readings]
    rows = [row | {"table": row["table"] if isfinite(row["table"]) else None} for row in told]
    centres = {link: None if at is None else {"x": at.real, "y": at.imag} for link, at in graph.centres.items()}
    return {"row": graph.row, "time": graph.time, "scale": graph.scale, "rows": rows, "centres": centres}


def _finding(finding: Finding) -> dict[str, Any]:
    kept = ("code", "group", "verdict", "value", "unit", "limit", "column", "row", "sentence")
    more = [name for name in ("step", "first", "last") if getattr(finding, name) is not None]
    return {name: getattr(finding, name) for name in (*kept, *more)}


def as_json(content: dict[str, Any]) -> bytes:
    """Return a record as JSON bytes: one line per key, and one line per item if the value is a list of records."""
    lines = ",\n".join(f" {_written(key)}: {_lines(value)}" for key, value in content.items())
    return f"{{\n{lines}\n}}\n".encode("utf-8", "backslashreplace")


def _lines(value: Any) -> str:
    if not (isinstance(value, list) and value and isinstance(value[0], dict)):
        return _written(value)
    return "[\n  " + ",\n  ".join(map(_written, value)) + "\n ]"


_written = json.JSONEncoder(ensure_ascii=False, allow_nan=False).encode
