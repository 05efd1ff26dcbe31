"""The page of a whole class: first what needs a look, then how the class did, in pictures where these say more.

Enters: `ClassFacts`, changes since the last run, the words of a language.  Leaves: HTML without script.  Used by `written.py`.
"""

from __future__ import annotations

import statistics
from collections import Counter
from collections.abc import Collection, Mapping, Sequence

from coursework.grading.marking.reasons.reason import misconception_sentence
from coursework.grading.marking.rubric import PARTS
from coursework.grading.pages.class_facts import ClassFacts
from coursework.grading.pages.feedback import shown_points
from coursework.report.graphs.strips import Strip, strip
from coursework.report.text.symbols import symbol
from coursework.report.text.text_runs import Run, runs
from coursework.words.sentence import Sentence
from coursework.words.sentences import Phrases, joined, say
from coursework.words.stylesheets import fitted
from coursework.words.templates import clean, filled

TENTHS = 10  # parts of the distribution of points
MANY = 30  # from so many values on, bars are clearer than single marks
MOST_LISTED = 200
# A file shared by more than this part of the class (and by more than FEW) was handed out: its owners are counted, not listed.
GIVEN, FEW = 0.25, 6


def class_page(
    facts: ClassFacts, changes: Sequence[tuple[str, str, str, str]], not_on_roster: Sequence[tuple[str, Sequence[str]]],
    words: Phrases,
) -> str:  # fmt: skip
    """Return the page; `changes` are (id, before, after, reason), `not_on_roster` (name, files)."""
    scores, first_rows = facts.scores, facts.first_rows
    first, last = (min(first_rows), max(first_rows)) if first_rows else (1, 0)
    named = sorted(facts.misconceptions.items(), key=lambda item: (-len(item[1]), item[0]))
    parts = [place for place in range(len(PARTS)) if any(one.parts[place] is not None for one in facts.everyone)]
    called, alike = _called(facts), _alike(facts)
    content = {
        "count": len(facts.everyone),
        "states": [(_state(state), number) for state, number in sorted(facts.states.items())],
        "graded": len(scores),
        "mean": shown_points(statistics.fmean(scores), words) if scores else "–",
        "median": shown_points(statistics.median(scores), words) if scores else "–",
        "most": shown_points(facts.most, words),
        "distribution": _tenths(scores, facts.most, words),
        "first_rows": [(str(row), first_rows[row]) for row in range(first, last + 1)],
        "heading": _heading(facts, len({one.id for one in facts.to_look_at} | alike), words),
        "points": _strip(scores, 0.0, facts.most, [shown_points(end, words) for end in (0.0, facts.most)], words),
        "firsts": _strip(list(first_rows.elements()), first, last, [str(first), str(last)], words),
        "hardest": _hardest(facts, words),
        "columns": [(runs(_symbol(name)), number) for name, number in facts.first_columns.most_common()],
        "misconceptions": [
            (misconception_sentence(code), len(ids), _listed([called[who] for who in ids])) for code, ids in named
        ],
        "to_look_at": [
            (called[one.id], one.page, _state(one.state), clean(one.reason)) for one in facts.to_look_at[:MOST_LISTED]
        ],
        "same_files": [_same(files, ids, called) for ids, files in sorted(facts.shared.items())[:MOST_LISTED]],
        "other_data": [(called[who], clean(whose)) for who, whose in facts.other_data[:MOST_LISTED]],
        "parts": [say(f"feedback.part.{PARTS[place]}") for place in parts],
        "everyone": [
            (
                called[one.id],
                one.page,
                _state(one.state),
                one.id in alike,
                shown_points(one.score, words),
                [shown_points(one.parts[place], words) for place in parts],
                runs(f"{words.said('gate.row', row=one.first[0])} {_symbol(one.first[1])}" if one.first else ""),
            )
            for one in facts.everyone
        ],
        "variants": _by_variant(facts, words),
        "changes": [
            (called.get(who, clean(who)), _mark(before, words), _mark(after, words), say(f"class.reason.{why}"))
            for who, before, after, why in changes[:MOST_LISTED]
        ],
        "not_on_roster": [(clean(name), _listed(files)) for name, files in not_on_roster[:MOST_LISTED]],
    }
    return fitted(filled("class.html.j2", say=words.said, language=words.language, **words.throughout(content)))


def _by_variant(facts: ClassFacts, words: Phrases) -> list[tuple[str, int, str]]:
    """Return each variant with the number and mean of its scores; none if all have the same one, or each another."""
    variants = sorted(facts.by_variant.items())
    if not 1 < len(variants) < sum(len(scores) for _, scores in variants):
        return []
    return [(clean(name), len(scores), shown_points(statistics.fmean(scores), words)) for name, scores in variants[:MOST_LISTED]]


def _state(state: str) -> Sentence:
    return say(f"feedback.state.{state.replace('-', '_')}")


def _mark(mark: str, words: Phrases) -> str:
    """Return a grade from changes.csv as a person reads it: points, a state, or "–" for none."""
    if not mark:
        return "–"
    return shown_points(float(mark), words) if mark[:1].isdigit() else _state(mark)


def _alike(facts: ClassFacts) -> set[str]:
    """Return who handed in work that is alike, which a person should look at; not who shares a file that was handed out."""
    shared = {who for ids in facts.shared if not _was_given(ids, facts.everyone) for who in ids}
    return shared | {who for who, _ in facts.other_data}


def _was_given(ids: Sequence[str], everyone: Collection[object]) -> bool:
    return len(ids) > max(FEW, GIVEN * len(everyone))


def _heading(facts: ClassFacts, look: int, words: Phrases) -> str:
    """Return the heading: the variant, the number of submissions, and how many of them need a person."""
    names = [clean(name) for name in dict.fromkeys(one.variant for one in facts.everyone if one.variant)]
    key = "class.heading" if len(names) == 1 else "class.heading_several"
    return words.said(key, variant=names[0] if names else "", count=len(facts.everyone), look=look)


def _hardest(facts: ClassFacts, words: Phrases) -> list[Run]:
    """Return a sentence on the column with the most first wrong cells, or on all of them if several are equal."""
    counts = facts.first_columns
    most = max(counts.values(), default=0)
    names = [_symbol(name) for name, number in sorted(counts.items()) if number == most]
    return runs(words.said("class.hardest" if len(names) == 1 else "class.hardest_alike", name=words.listing(names)))


def _strip(values: Sequence[float], low: float, high: float, ends: Sequence[str], words: Phrases) -> Strip | None:
    """Return a strip with one mark for each value and the median; None if there are no values or MANY."""
    if not values or len(values) >= MANY:
        return None
    median = statistics.median(values)
    return strip(values, low, high, median, (ends[0], ends[1]), shown_points(median, words))


def _symbol(name: str) -> str:
    return symbol(name).text if name.isidentifier() else clean(name)


def _called(facts: ClassFacts) -> dict[str, str]:
    """Return how the page calls each id: by name, or by the id if the name is missing or not unique."""
    times = Counter(one.name for one in facts.everyone)
    return {one.id: clean(one.name if times[one.name] == 1 else one.id, 80) for one in facts.everyone}


def _same(files: Sequence[str], ids: Sequence[str], called: Mapping[str, str]) -> Sentence:
    """Return who shares some files, or only how many if a large part of the class does."""
    named = joined([clean(name, 80) for name in sorted(set(files))], "join.comma")
    if _was_given(ids, called):
        return say("class.same_given", files=named, number=len(ids))
    return say("class.same", files=named, who=_listed([called[who] for who in ids]))


def _tenths(scores: Sequence[float], most: float, words: Phrases) -> list[tuple[str, int]]:
    """Return how many scores lie in each tenth of the most points; full points are in the last one."""
    counts = Counter(min(int(TENTHS * score / (most or 1.0)), TENTHS - 1) for score in scores)
    edges = [shown_points(most * part / TENTHS, words) for part in range(TENTHS + 1)]
    return [(f"{edges[part]}–{edges[part + 1]}", counts[part]) for part in range(TENTHS)]


def _listed(names: Sequence[str]) -> Sentence:
    more = ["…"] if len(names) > 30 else []
    return joined([*(clean(name, 80) for name in names[:30]), *more], "join.comma")
