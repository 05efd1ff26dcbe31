"""Which hypothesis explains a wrong table: it is named only if the printed digits prove it, and earns what it explains.

Enters: a `Key`, marked cells.  Leaves: `Found`.
Used by `earning.py`, `grade.py`, `whole.py`, `verdicts.py`, `table_marks.py`, and the reasons of a table.
"""

from __future__ import annotations

from collections.abc import Callable, Container, Iterable, Iterator, Sequence
from dataclasses import replace
from functools import cached_property
from typing import Any

import numpy as np

from coursework.grading.marking.equations.marks import EquationMarks
from coursework.grading.marking.key.key import Key
from coursework.grading.marking.table.causes.claims import Claim
from coursework.grading.marking.table.causes.closer import as_it_was, closer
from coursework.grading.marking.table.causes.hypotheses import OTHER_STEP, ROUNDED_OMEGA
from coursework.grading.marking.table.causes.odd_rows import displaced_rows
from coursework.grading.marking.table.causes.other_data import may_be
from coursework.grading.marking.table.causes.own_equations import OWN
from coursework.grading.marking.table.causes.own_rows import on_own_rows
from coursework.grading.marking.table.causes.step_lengths import told_step
from coursework.grading.marking.table.cells import Cells, alike, mark_cells
from coursework.grading.marking.table.explained import Explained, Fit, euler_cells, share_of
from coursework.grading.marking.table.points import stands_still, table_points
from coursework.grading.marking.table.starts import OwnStart, begins_elsewhere, own_start
from coursework.grading.marking.table.untold import FINEST, ramp, untold_cells
from coursework.grading.marking.table.ways import KEY, StudentTable, near
from coursework.system.arrays import Flags
from coursework.system.frozen import caching, frozen

# A cause is named from the share NAMED on, if it explains BETTER more than Euler's rules; one that is worse by TIE is a tie.
NAMED, BETTER, TIE = 0.93, 0.02, 0.005
# A table with at most so many wrong cells, or this part of its cells, has slips, not a misconception.
FEWEST, FEWEST_SHARE = 2, 0.02
_CHANCE = 0.03  # part of the cells that a cause may explain alone by chance
ROWS_SHIFTED, ORIGIN = "rows_shifted", "origin_"


@frozen
class Misconception:
    """`code` explains `share` of the cells it speaks about, Euler's rules `euler_share` of theirs; `ties` explain as much.

    `names` are the columns, starts or equations concerned, or a datum's value and unit, or a step's value; mostly empty.
    """

    code: str
    share: float
    euler_share: float
    ties: tuple[str, ...]
    names: tuple[str, ...] = ()

    def plain(self) -> dict[str, Any]:
        """Return the record as grades.json writes it."""
        shares = {"share": round(self.share, 4), "euler_share": round(self.euler_share, 4)}
        return {"code": self.code, **shares, "ties": list(self.ties)}


@caching
class Found:
    """What is `named` with good reason, and what explains anything at all.

    `at_best` are the causes with the most that each can explain of the table; what they do explain takes a `closer_look`.
    `from_own_start` is the table marked against Euler's from the student's own start, None if that explains nothing. `untold`
    (n, m + r) are right cells that the digits cannot tell from the best explanation; None if the table was not examined.
    """

    named: Misconception | None = None
    at_best: tuple[Fit, ...] = ()
    closer_look: Callable[[], tuple[Fit, ...]] = tuple
    from_own_start: OwnStart | None = None
    untold: Flags | None = None

    @cached_property
    def fits(self) -> tuple[Fit, ...]:
        """Return what explains more than Euler's rules do, or than the cells alone, one `Fit` for each code."""
        return self.closer_look()

    @property
    def own_line(self) -> str:
        """Return the line of the student's own equations from which the table follows, "" if it follows from none."""
        fits = self.fits if any(fit.code == OWN for fit in self.at_best) else ()
        return next((fit.names[0] for fit in fits if fit.code == OWN and fit.share >= NAMED and fit.beyond_euler), "")


def looked_for(key: Key, cells: Cells, count: int) -> bool:
    """Return whether to look for a misconception: of `count` cells many are wrong, or the start, the times or whole rows are.

    In a steady drive the rows after a repeated one follow each other again, and few cells are wrong.
    """
    wrong = int(cells.wrong.sum())
    if wrong > max(FEWEST, FEWEST_SHARE * count) or begins_elsewhere(key, cells) or cells.student.own is not None:
        return True
    return wrong > 0 and bool(displaced_rows(key, cells))


def explanations(
    key: Key,
    cells: Cells,
    told: Iterable[Claim],
    hidden: Container[str] = (),
    equations: EquationMarks | None = None,
) -> Found:
    """Return the causes that explain more of a table than Euler's rules do, of those that its claims (`told`) name.

    A table that begins elsewhere may follow Euler's rules in every row; a cause that claims the whole table is then compared
    with the key.  Nothing explains a table that stands still: zeros fulfil every rule for a step.
    """
    if stands_still(key, cells):
        return Found()
    began = own_start(key, cells)
    weighed = _Weighed(Explained(key, cells), hidden, elsewhere=began is not None or begins_elsewhere(key, cells))
    for claim in told:
        if claim.code not in hidden or claim.code.startswith(ROUNDED_OMEGA):
            weighed.hear(claim)
    untold = _untold(key, cells, *weighed.teller) if weighed.teller else np.zeros_like(cells.wrong)
    further: list[Fit] = []
    if (own := cells.student.own) and (fitting := on_own_rows(key, cells, own)):
        share, fit = fitting
        if share >= NAMED:
            weighed.name_step(share, told_step(own.step))
            untold[:, : key.m] = cells.counted[:, : key.m]
        if fit > weighed.euler_fit + BETTER:
            further.append(Fit(OTHER_STEP, fit, in_print=True))  # beside what the rows as handed in say of it
    if began and (share := share_of(*euler_cells(began.cells))) >= NAMED and share > weighed.of_whole + BETTER:
        weighed.named[began.cause] = Misconception(began.cause, share, weighed.of_whole, (), began.names)
    at_best = (*weighed.at_best(), *further)
    return Found(weighed.likeliest(equations), at_best, lambda: (*weighed.better_fits(), *further), began, untold)


class _Weighed:
    """What claims explain of a table, weighed against what Euler's rules and the key do; it may begin `elsewhere`.

    `euler` and `by_key` are the shares of Euler's rules and of the key, `as_handed_in` that of either; `of_whole` is what a claim
    about the whole table is compared with: Euler's rules, unless the table begins elsewhere.
    """

    def __init__(self, gates: Explained, hidden: Container[str], *, elsewhere: bool) -> None:
        self.gates, self.hidden = gates, hidden
        self.explained, spoken = euler_cells(gates.cells)
        self.euler_fit = gates.share(self.explained, as_it_is=True)
        right = self.explained | gates.by_key
        shares = (share_of(one & spoken, spoken) for one in (self.explained, gates.by_key, right))
        self.euler, self.by_key, self.as_handed_in = shares
        self.of_whole = self.by_key if elsewhere else self.euler
        self.named: dict[str, Misconception] = {}
        self.read_off: set[str] = set()
        self.fits: dict[tuple[str, bool], Fit] = {}
        self.held: dict[str, tuple[int, Claim, Flags]] = {}
        self.most_told: tuple[float, bool] = right.sum() + BETTER * spoken.sum(), False
        self.teller: tuple[Claim, Flags] | None = None  # the claim that explains most cells, and which ones

    def hear(self, claim: Claim) -> None:
        """Keep what a claim explains."""
        code = claim.code
        put_right, holds, says = self._claimed(claim)
        share, against = share_of(holds, says), self._against(claim)
        is_better = share >= NAMED and share > against + BETTER and (code not in self.named or share > self.named[code].share)
        if is_better and code != OWN and code not in self.hidden:
            self.named[code] = Misconception(code, share, against, (), claim.names)
            self.read_off |= {code} if claim.is_read_off else set()
        if not self._gains(claim, holds):
            return
        gates = self.gates if put_right is self.gates.cells else Explained(self.gates.key, put_right)
        excuses = self._excuses(holds) if claim.student is None else 1.0
        self._fit(Fit(code, gates.share(holds, excuses=excuses), claim.names, in_print=claim.student is not None))
        count = int((holds | self.gates.by_key).sum())
        if (count, not claim.is_read_off) > self.most_told and code not in self.hidden:
            self.most_told, self.teller = (count, not claim.is_read_off), (claim, holds)
        # Causes that leave something unexplained are examined again.
        if claim.student is None and count < self.gates.spoken.sum() and (code not in self.held or count > self.held[code][0]):
            self.held[code] = count, claim, holds

    def _against(self, claim: Claim) -> float:
        """Return the share that a claim must exceed."""
        usual = self.of_whole if claim.is_whole else self.euler
        if claim.student is None or claim.code.startswith(ORIGIN):
            return usual
        # In a steady drive, rows in wrong places still follow Euler's rules; in a table made anew, what stood right stays right.
        return self.by_key if claim.code == ROWS_SHIFTED else max(usual, self.as_handed_in)

    def _gains(self, claim: Claim, holds: Flags) -> bool:
        """Return whether a claim about cells as they stand explains any that neither Euler's rules nor the key do.

        Else the cells that its other steps would excuse are all that it has: at two decimals a step ten times too long once
        was worth more than the wrong equation that explained the table.
        """
        as_it_stands = claim.student is None and not claim.is_whole
        return not as_it_stands or bool((holds & ~self.explained & ~self.gates.by_key).any())

    def _excuses(self, holds: Flags) -> float:
        """Return the part (0 to 1) of cells beside cells put right that a claim may excuse: none if it alone explains few."""
        alone = holds & ~self.explained & ~self.gates.by_key
        return ramp(share_of(alone, self.gates.spoken), _CHANCE, 2 * _CHANCE)

    def _look_closer(self) -> None:
        """Hold the likeliest claims against the whole table."""
        key, cells = self.gates.key, self.gates.cells
        for code, claim, holds in closer(self.held):
            holds = holds | as_it_was(key, cells, claim)
            table = claim.table() if claim.table else None
            fit = self.gates.share(holds, table=table, excuses=self._excuses(holds))
            self._fit(Fit(code, fit, claim.names))

    def at_best(self) -> Iterator[Fit]:
        """Yield what each cause explains, or all of the table if a closer look may find that."""
        yield from self.fits.values()
        yield from (Fit(code, 1.0, claim.names) for code, claim, _ in closer(self.held))

    def better_fits(self) -> Iterator[Fit]:
        """Yield the fits that explain more than the cells alone or Euler's rules do, after a closer look."""
        self._look_closer()
        least = min(self.euler_fit, table_points(self.gates.key, self.gates.cells).share)
        for fit in self.fits.values():
            is_whole = fit.code.startswith((ROWS_SHIFTED, ORIGIN))
            if is_whole or fit.share > least + BETTER:
                yield replace(fit, beyond_euler=is_whole or fit.share > self.euler_fit + BETTER)

    def name_step(self, share: float, step: str) -> None:
        """Name the step that the table's own times prove, even if its digits do not.

        If its rows leave out steps of the task, other rules explain only the velocities.
        """
        self.named = {code: one for code, one in self.named.items() if one.share > share + TIE or code == OTHER_STEP}
        share = max(share, self.named[OTHER_STEP].share) if OTHER_STEP in self.named else share
        self.named[OTHER_STEP] = Misconception(OTHER_STEP, share, self.euler, (), (step,))

    def likeliest(self, equations: EquationMarks | None) -> Misconception | None:
        """Return the cause that explains most, with its ties; None if there is none."""
        named = self.named
        best = max((one.share for one in named.values()), default=0.0)
        tied = [code for code, one in named.items() if one.share >= best - TIE]
        tied = [code for code in tied if may_be(self.gates.key, code, named[code].names)] or tied
        tied = [code for code in tied if code not in self.read_off and is_one_thing(code, named[code].names)] or tied
        if equations is not None and equations.wrong:  # what stands in the equations, too, is likelier than what does not
            tied.sort(key=lambda code: not code.startswith("equation_"))
        return replace(named[tied[0]], ties=tuple(tied[1:])) if tied else None

    def _fit(self, fit: Fit) -> None:
        place = fit.code, fit.in_print
        if place not in self.fits or fit.share > self.fits[place].share:
            self.fits[place] = fit

    def _claimed(self, claim: Claim) -> tuple[Cells, Flags, Flags]:
        """Return the cells that a claim speaks about, and flags: which of them it explains, and about which it says anything.

        In columns that it leaves alone, Euler's rules hold.
        """
        key, cells, spoken = self.gates.key, self.gates.cells, self.gates.spoken
        if claim.student is not None:
            put_right = mark_cells(key, claim.student)
            follows, speaks = euler_cells(put_right)
            return put_right, follows | (speaks & (put_right.marks == KEY)), speaks
        says = np.isfinite(claim.expected) & spoken
        holds = near(cells.student.values, claim.expected, claim.tolerance) & says
        of_euler = np.isnan(claim.expected).all(axis=0)
        says[:, of_euler], holds[:, of_euler] = spoken[:, of_euler], self.explained[:, of_euler]
        return cells, holds, says


def is_one_thing(code: str, names: Sequence[str]) -> bool:
    """Return whether a cause is a single fault; slips in several equations are several, and so are several starts."""
    return len(names) < 2 or not code.startswith(("equation_", "start_"))


def _untold(key: Key, cells: Cells, claim: Claim, holds: Flags) -> Flags:
    """Return right cells (n, m + r) whose digits are too few to differ from what a claim expects, where the claim `holds`."""
    if claim.student is not None:
        return np.zeros_like(holds)
    table = claim.table() if claim.table else None
    found = untold_cells(key, cells, claim.expected, holds, table)
    if table is None or not found.any():
        return found
    made = mark_cells(key, StudentTable(table, np.full(table.shape, FINEST)))
    points = table_points(key, made)
    nothing = made.wrong | (made.missing if points.uncounted is None else made.missing | points.uncounted)
    return np.asarray(found | ((cells.marks == KEY) & nothing & cells.counted & alike(key, cells.student, table)))
