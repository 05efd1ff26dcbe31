"""Which hypothesis explains a wrong table: it is named only if the printed digits prove it, and earns what it explains.

Enters: a `Key`, marked cells.  Leaves: `Found`.
Used by `earning.py`, `grade.py`, `whole.py`, `verdicts.py`, `table_marks.py`, and the reasons of a table.
"""

from __future__ import annotations

from collections.abc import Container, Iterable, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from coursework.grading.marking.equations.equations import EquationMarks
from coursework.grading.marking.key.key import Key
from coursework.grading.marking.table.causes.claims import Claim, TableUnderTest
from coursework.grading.marking.table.causes.hypotheses import OTHER_STEP
from coursework.grading.marking.table.causes.misread_key import MisreadKey
from coursework.grading.marking.table.causes.odd_rows import displaced_rows
from coursework.grading.marking.table.causes.other_data import may_be
from coursework.grading.marking.table.causes.own_equations import OWN
from coursework.grading.marking.table.causes.own_rows import on_own_rows
from coursework.grading.marking.table.causes.step_lengths import told_step
from coursework.grading.marking.table.cells import Cells, alike, mark_cells
from coursework.grading.marking.table.explained import Explained, Fit, euler_cells, share_of
from coursework.grading.marking.table.points import stands_still, table_points
from coursework.grading.marking.table.starts import OwnStart, begins_elsewhere, own_start
from coursework.grading.marking.table.untold import FINEST, untold_cells
from coursework.grading.marking.table.ways import KEY, OwnRows, StudentTable, near
from coursework.system.arrays import Flags
from coursework.system.frozen import frozen

# A cause is named from the share NAMED on, if it explains BETTER more than Euler's rules; one that is worse by TIE is a tie.
NAMED, BETTER, TIE = 0.93, 0.02, 0.005
# A table with at most so many wrong cells, or this part of its cells, has slips, not a misconception.
FEWEST, FEWEST_SHARE = 2, 0.02
# For so many of the hypotheses that explain most the whole table is computed.
_CLOSER, _READ_OFF = 3, 2
ROWS_SHIFTED, ORIGIN, ROUNDED_OMEGA = "rows_shifted", "origin_", "rounded_omega_"


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


@frozen
class Found:
    """What is `named` with good reason, and what explains anything at all, one `Fit` for each code.

    `from_own_start` is the table marked against Euler's from the student's own start, None if that explains nothing. `untold`
    (n, m + r) are right cells that the digits cannot tell from the best explanation; None if the table was not examined.
    """

    named: Misconception | None = None
    fits: tuple[Fit, ...] = ()
    from_own_start: OwnStart | None = None
    untold: Flags | None = None

    @property
    def own_line(self) -> str:
        """Return the line of the student's own equations from which the table follows, "" if it follows from none."""
        return next((fit.names[0] for fit in self.fits if fit.code == OWN and fit.share >= NAMED and fit.beyond_euler), "")


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
    weighed = _Weighed(key, cells, hidden, elsewhere=began is not None or begins_elsewhere(key, cells))
    for claim in told:
        if claim.code not in hidden or claim.code.startswith(ROUNDED_OMEGA):
            weighed.hear(claim)
    weighed.look_closer()
    untold = _untold(key, cells, *weighed.teller) if weighed.teller else np.zeros_like(cells.wrong)
    fits = weighed.better_fits()
    if (own := cells.student.own) and (fitting := _other_step(key, cells, own)):
        share, fit = fitting
        if share >= NAMED:
            weighed.name_step(share, told_step(own.step))
            untold[:, : len(key.coordinates)] = cells.counted[:, : len(key.coordinates)]
        if fit > weighed.euler_fit + BETTER:
            fits[OTHER_STEP, True] = Fit(OTHER_STEP, fit)  # beside what the rows as handed in say of it
    if began and (share := share_of(*euler_cells(key, began.cells))) >= NAMED and share > weighed.key_share + BETTER:
        weighed.named[began.cause] = Misconception(began.cause, share, weighed.key_share, (), began.names)
    return Found(weighed.likeliest(equations), tuple(fits.values()), began, untold)


class _Weighed:
    """What claims explain of a table, weighed against what Euler's rules and the key do; it may begin `elsewhere`."""

    def __init__(self, key: Key, cells: Cells, hidden: Container[str], *, elsewhere: bool) -> None:
        self.key, self.cells, self.hidden, self.gates = key, cells, hidden, Explained(key, cells)
        self.explained, self.spoken = euler_cells(key, cells)
        self.by_key = np.asarray(cells.marks == KEY)
        self.euler_share, self.euler_fit = share_of(self.explained, self.spoken), self.gates.share(self.explained, as_it_is=True)
        right = self.explained | self.by_key
        # In a steady drive, rows in wrong places still follow Euler's rules; in a table made anew, what stood right stays right.
        self.stands, self.as_handed_in = (share_of(one & self.spoken, self.spoken) for one in (self.by_key, right))
        self.key_share = self.stands if elsewhere else self.euler_share
        self.named: dict[str, Misconception] = {}
        self.read_off: set[str] = set()
        self.fits: dict[tuple[str, bool], Fit] = {}
        self.held: dict[str, tuple[int, Claim, Flags]] = {}
        self.most_told: tuple[float, bool] = right.sum() + BETTER * self.spoken.sum(), False
        self.teller: tuple[Claim, Flags] | None = None  # the claim that explains most cells, and which ones

    def hear(self, claim: Claim) -> None:
        """Keep what a claim explains."""
        code = claim.code
        put_right, holds, says = self._claimed(claim)
        share, against = share_of(holds, says), self.key_share if claim.is_whole else self.euler_share
        if claim.student is not None and not code.startswith(ORIGIN):
            against = self.stands if code == ROWS_SHIFTED else max(against, self.as_handed_in)
        is_better = share >= NAMED and share > against + BETTER and (code not in self.named or share > self.named[code].share)
        if is_better and code != OWN and code not in self.hidden:
            self.named[code] = Misconception(code, share, against, (), claim.names)
            self.read_off |= {code} if claim.is_read_off else set()
        gates = self.gates if put_right is self.cells else Explained(self.key, put_right)
        self._fit(Fit(code, gates.share(holds), claim.names, in_print=claim.student is not None))
        count = int((holds | self.by_key).sum())
        if (count, not claim.is_read_off) > self.most_told and code not in self.hidden:
            self.most_told, self.teller = (count, not claim.is_read_off), (claim, holds)
        # Causes that leave something unexplained are examined again.
        if claim.student is None and count < self.spoken.sum() and (code not in self.held or count > self.held[code][0]):
            self.held[code] = count, claim, holds

    def look_closer(self) -> None:
        """Hold the likeliest claims against the whole table."""
        key, cells = self.key, self.cells
        for code, claim, holds in _closer(self.held):
            as_it_was = _by_its_own_rules if claim.velocities_at else _as_it_was
            fit = self.gates.share(holds | as_it_was(key, cells, claim), table=claim.table() if claim.table else None)
            self._fit(Fit(code, fit, claim.names))

    def better_fits(self) -> dict[tuple[str, bool], Fit]:
        """Return the fits that explain more than the cells alone or Euler's rules do."""
        least = min(self.euler_fit, table_points(self.key, self.cells).share)
        found = {}
        for place, fit in self.fits.items():
            is_whole = fit.code.startswith((ROWS_SHIFTED, ORIGIN))
            if is_whole or fit.share > least + BETTER:
                found[place] = replace(fit, beyond_euler=is_whole or fit.share > self.euler_fit + BETTER)
        return found

    def name_step(self, share: float, step: str) -> None:
        """Name the step that the table's own times prove, even if its digits do not.

        If its rows leave out steps of the task, other rules explain only the velocities.
        """
        self.named = {code: one for code, one in self.named.items() if one.share > share + TIE or code == OTHER_STEP}
        share = max(share, self.named[OTHER_STEP].share) if OTHER_STEP in self.named else share
        self.named[OTHER_STEP] = Misconception(OTHER_STEP, share, self.euler_share, (), (step,))

    def likeliest(self, equations: EquationMarks | None) -> Misconception | None:
        """Return the cause that explains most, with its ties; None if there is none."""
        named = self.named
        best = max((one.share for one in named.values()), default=0.0)
        tied = [code for code, one in named.items() if one.share >= best - TIE]
        tied = [code for code in tied if may_be(self.key, code, named[code].names)] or tied
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
        if claim.student is not None:
            put_right = mark_cells(self.key, claim.student)
            follows, speaks = euler_cells(self.key, put_right)
            return put_right, follows | (speaks & (put_right.marks == KEY)), speaks
        holds = near(self.cells.student.values, claim.expected, claim.tolerance)
        says = np.isfinite(claim.expected) & self.spoken
        holds &= says
        of_euler = np.isnan(claim.expected).all(axis=0)
        says[:, of_euler], holds[:, of_euler] = self.spoken[:, of_euler], self.explained[:, of_euler]
        return self.cells, holds, says


def _closer(held: Mapping[str, tuple[int, Claim, Flags]]) -> list[tuple[str, Claim, Flags]]:
    """Return the claims to hold against the whole table: of most cells, data read off, which a column put right hides, and
    velocities rounded: nearly the task's, they explain fewer cells than many a cause that is worth less.
    """
    by_count = sorted(held.items(), key=lambda found: -found[1][0])
    rest = by_count[_CLOSER:]
    data = [found for found in rest if found[1][1].is_read_off][:_READ_OFF]
    rounded = [found for found in rest if found[0].startswith(ROUNDED_OMEGA)]
    return [(code, claim, holds) for code, (_, claim, holds) in (*by_count[:_CLOSER], *data, *rounded)]


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


def _by_its_own_rules(key: Key, cells: Cells, claim: Claim) -> Flags:
    """Return which cells are right if the velocities of a claim are taken for the task's, slips being marked as in any table.

    A cell with the task's value had the claim's before it was put right; what follows from the earlier value is right too.
    """
    assert claim.velocities_at is not None and claim.table is not None
    own = MisreadKey(key.variant, key.model, key.table, made_with=claim.velocities_at, part=claim.part, task=key)
    table = claim.table()
    made = mark_cells(own, cells.student, table)
    right = ~made.wrong & ~made.missing
    put = alike(key, cells.student, key.table) & ~alike(key, cells.student, table)
    if not put.any():
        return right
    before = mark_cells(own, replace(cells.student, values=np.where(put, table, cells.student.values)), table)
    return right | (~before.wrong & ~before.missing & ~put)


def _as_it_was(key: Key, cells: Cells, claim: Claim) -> Flags:
    """Return which cells a claim explains by its whole table, or by the values that stood there before cells were put right."""
    values = cells.student.values
    with np.errstate(invalid="ignore"):
        put = (cells.marks == KEY) & (np.abs(values - claim.expected) > claim.tolerance)
    was = np.where(put, claim.expected, values if cells.before is None else cells.before.values)
    none = np.zeros(values.shape, dtype=bool)
    whole = none if claim.table is None else alike(key, cells.student, claim.table())
    if claim.family is None or np.array_equal(was, values, equal_nan=True):
        return whole
    before = TableUnderTest(key, replace(cells.student, values=was))
    found = [near(values, one.expected, one.tolerance) for one in claim.family(before) if one.code == claim.code]
    best = max(found, key=np.count_nonzero, default=none)
    if np.isnan(claim.expected[:, : before.m]).all():
        units = before.w_units[:, : before.m]
        best[:, : before.m] |= near(values[:, : before.m], *before.steps(key.step * before.w, key.step * units))
    return best | whole


def _other_step(key: Key, cells: Cells, own: OwnRows) -> tuple[float, float] | None:
    """Return two shares that are right on the table's own times: of cells, behind the gates; None if no motion has these."""
    found = on_own_rows(key, cells, own)
    if found is None:
        return None
    right, says = euler_cells(found.key, found.cells)
    right |= found.put_right & says
    return share_of(right, says), found.filled * Explained(found.key, found.cells).share(right)
