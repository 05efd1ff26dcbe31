"""`@frozen` beside the standard decorator, which is the judge: the same classes, the same answers."""

import copy
import pickle
from dataclasses import FrozenInstanceError, asdict, dataclass, field, fields, replace
from functools import cached_property
from typing import ClassVar

import pytest

from coursework.system.frozen import caching, changing, frozen, single


def family(decorate):
    """Return some classes of every shape that the house has, so decorated."""

    @decorate
    class Empty:
        """Nothing."""

    @decorate
    class One:
        value: object

    @decorate
    class Several:
        first: float
        second: str = "x"
        listed: list = field(default_factory=list)
        hidden: dict = field(default_factory=dict, repr=False, compare=False)
        made: float = field(init=False)
        fixed: str = field(init=False, default="f")

        def __post_init__(self):
            object.__setattr__(self, "made", 2 * self.first)

    @decorate
    class Heir(Several):
        second: str = "y"
        third: int = 3

        def __str__(self):
            return "own"

    @decorate
    class Told:
        kind: ClassVar[str] = "x"
        later: "ClassVar[int]" = 1
        value: "float | None" = None

    @decorate
    class OwnWays:
        value: float

        def __eq__(self, other):
            return abs(self.value - other.value) < 1

        def __hash__(self):
            return 1

        def __repr__(self):
            return "own"

    return {kind.__name__: kind for kind in (Empty, One, Several, Heir, Told, OwnWays)}


OURS = family(frozen)
PAIRS = [
    (OURS, family(dataclass(frozen=True, slots=True))),
    (family(caching), family(dataclass(frozen=True))),
    (family(changing), family(dataclass(slots=True))),
]
CALLS = [
    ("Empty", (), {}), ("One", (1,), {}), ("One", ("a",), {}), ("One", ((1, 2),), {}), ("Several", (1.0,), {}),
    ("Several", (1.0, "z"), {"listed": [1]}), ("Several", (), {"first": 2.0, "hidden": {1: 2}}), ("Heir", (1.0,), {"third": 4}),
    ("Told", (0.5,), {}), ("Told", (), {"kind": "y"}),
    ("OwnWays", (0.5,), {}), ("One", (), {}), ("One", (1, 2), {}), ("Several", (1.0,), {"made": 1}), ("Empty", (), {"x": 1}),
]  # fmt: skip


def answers(kinds, call):
    """Return all that can be asked of what a call makes."""
    name, arguments, named = call
    try:
        one, twin = (kinds[name](*arguments, **named) for _ in range(2))
    except TypeError as error:
        return str(error)
    try:
        number = hash(one)
    except TypeError as error:
        number = str(error)
    copies = [copy.copy(one), copy.deepcopy(one), replace(one)]
    return (
        repr(one), str(one), number, asdict(one), one == twin, one != twin, one == 1 if name != "OwnWays" else None,
        [each == one for each in copies], [(each.name, each.type) for each in fields(one)],
        one.__match_args__, hasattr(one, "__dict__"),
        type(one).__eq__(one, twin),
    )  # fmt: skip


@pytest.mark.parametrize("call", CALLS, ids=str)
@pytest.mark.parametrize(("ours", "theirs"), PAIRS, ids=["frozen", "caching", "changing"])
def test_the_same_answers(call, ours, theirs):
    assert answers(ours, call) == answers(theirs, call)


def test_records_of_two_classes_differ():
    assert OURS["One"](1) != PAIRS[0][1]["One"](1)
    assert OURS["Several"](1.0, "y") != OURS["Heir"](1.0)


def test_a_single_record_equals_only_itself():
    ours, theirs = family(single), family(dataclass(frozen=True, slots=True, eq=False))
    for kinds in (ours, theirs):
        one, twin = kinds["Heir"](1.0), kinds["Heir"](1.0)
        assert (one == one, one == twin, hash(one) == hash(twin)) == (True, False, False)
        assert (repr(one), kinds["OwnWays"](0.5)) == (repr(twin), kinds["OwnWays"](0.6))


def test_what_is_frozen_stays():
    one = OURS["Heir"](1.0)
    for change in (lambda: setattr(one, "first", 2.0), lambda: setattr(one, "other", 1), lambda: delattr(one, "first")):
        with pytest.raises(FrozenInstanceError):
            change()
    assert one.first == 1.0


@frozen
class Travelling:
    """A record that goes to another process."""

    a: int
    b: tuple = ()


def test_it_is_pickled():
    one = Travelling(1, (2, Travelling(3)))
    assert pickle.loads(pickle.dumps(one)) == one


def test_room_for_what_is_computed_once():
    @caching
    class Circle:
        radius: float

        @cached_property
        def across(self):
            return 2 * self.radius

    one = Circle(1.0)
    assert one.across is one.across
    with pytest.raises(FrozenInstanceError):
        one.radius = 2.0


def test_it_may_hold_itself():
    one = Travelling(1, ([],))
    one.b[0].append(one)
    assert repr(one) == "Travelling(a=1, b=([...],))"


@pytest.mark.parametrize("decorate", [frozen, caching, changing])
def test_the_first_objects_of_a_class_are_made_as_all_later_ones(decorate):
    """The first ones are made without an `__init__` of the class, which is written out for many."""
    calls = [((1.0,), {}), ((1.0, "z"), {"listed": [1]}), ((), {"first": 2.0, "second": "w"})]
    wrong = [((), {}), ((1.0, "z", [], {}, 1), {}), ((1.0,), {"first": 2.0}), ((1.0,), {"made": 2.0}), ((1.0,), {"other": 0})]

    def outcomes(kind):
        found = []
        for values, named in [*calls, *wrong]:
            try:
                found.append(repr(kind(*values, **named)))
            except TypeError as error:
                found.append(str(error))
        return found

    early = [outcomes(family(decorate)["Several"]) for _ in range(2)]
    kind = family(decorate)["Several"]
    for _ in range(100):
        kind(1.0)
    assert early == [outcomes(kind)] * 2
    one, other = kind(1.0), kind(2.0)
    assert one.listed is not other.listed


class Counted:
    """Counts how often it is hashed."""

    asked = 0

    def __hash__(self):
        self.asked += 1
        return 7


@caching
class Holder:
    one: Counted


def test_an_object_that_caches_is_hashed_once_and_again_in_another_process():
    holder = Holder(Counted())
    assert hash(holder) == hash(holder) == hash((holder.one,)) and holder.one.asked == 2
    there = pickle.loads(pickle.dumps(holder))
    assert hash(there) == hash(holder) and there.one.asked == 3
