"""`coursework new --groups`: for any sequence of kinds the file runs as it is, and closes along the whole motion.

Positions are held against the ways round each loop, worked out here from the numbers of the file, not with the tool's groups.
"""

import os
import random
import re
import subprocess
import sys
import tomllib
from pathlib import Path

import numpy as np
import pytest

import coursework
from coursework.mechanism.drafts import candidates
from coursework.words.sentences import load_phrases
from tests.command import call
from tests.sample import first

pytestmark = pytest.mark.usefixtures("folder")

DYADS = ("RRR", "RRP", "RPR", "RPP", "PRP")
SHORT = [("crank", dyad) for dyad in DYADS]
LONG = [("crank", *random.Random(seed).choices((*DYADS, "crank"), k=3 + seed % 5)) for seed in (0, 1, 3, 4)]


def written(kinds, *more):
    result = call("new", "mine", "--groups", ",".join(kinds), *more)
    assert result.exit_code == 0, result.output
    return Path("mine.toml").read_text(encoding="utf-8")


def loops(data, run):
    """Yield both ways round the loop of each dyad, as complex numbers (n,) m."""
    exact = run.exact
    names = list(data["coordinates"])
    q = {name: exact.coordinates[:, place] for place, name in enumerate(names)}
    number = {
        name: float(value.split()[0]) * (np.pi / 180 if value.endswith("deg") else 1) for name, value in data["given"].items()
    }
    at = {
        name: 0 if text == "(0, 0)" else number[f"x{name}"] + 1j * number[f"y{name}"] for name, text in data["points"].items()
    }  # fmt: skip

    def e(angle):
        return np.exp(1j * angle)

    def direction(guide):
        return sum(q[part] if part in q else number[part] for part in guide["angle"].split(" + "))

    for group in data["group"]:
        own = [q[name] for name in group["coordinates"]]
        start = [at[name] for name in group.get("from", ())]
        rods = [number[name] for name in group.get("lengths", ())]
        guides = group.get("guides") or [group[key] for key in ("guide",) if key in group]
        if group["kind"] == "crank":
            at[group["meets"]] = start[0] + rods[0] * e(own[0])
            continue
        slides = [(at[guide["through"]], e(direction(guide))) for guide in guides]
        if group["kind"] == "RRR":
            ways = start[0] + rods[0] * e(own[0]), start[1] + rods[1] * e(own[1])
        elif group["kind"] == "RRP":
            ways = start[0] + rods[0] * e(own[0]), slides[0][0] + own[1] * slides[0][1]
        elif group["kind"] == "RPR":
            ways = start[0], start[1] + own[1] * e(own[0])
        elif group["kind"] == "RPP":
            ways = start[0], slides[0][0] + (own[1] + 1j * own[0]) * slides[0][1]
        else:
            ways = tuple(through + slide * along for (through, along), slide in zip(slides, own, strict=True))
        yield ways
        at[group["meets"]] = ways[0]
        if group["kind"] == "RPR":
            at[group["meets"]] = start[1] + rods[0] * e(own[0])
        elif group["kind"] == "RPP":
            at[group["meets"]] = slides[0][0] + own[1] * slides[0][1]


@pytest.mark.long
@pytest.mark.parametrize("kinds", first(len(SHORT) + 2, [[*kinds] for kinds in (*SHORT, *LONG)]), ids=",".join)
def test_any_sequence_closes_along_the_whole_motion(kinds):
    data = tomllib.loads(written(kinds))
    assert [group["kind"] for group in data["group"]] == list(kinds)
    run = coursework.solve("mine")
    assert run.stop is None
    assert all(check.verdict in {"PASS", "SKIP", "COARSE"} for check in run.checks)
    gaps = [float(np.abs(first - second).max()) for first, second in loops(data, run)]
    assert len(gaps) == sum(kind != "crank" for kind in kinds)
    assert max(gaps) < 1e-12
    assert run.scene.mechanism.mobility.degrees == kinds.count("crank")
    turned = {
        group["coordinates"][0]: np.ptp(run.exact.coordinates[:, list(data["coordinates"]).index(group["coordinates"][0])])
        for group in data["group"]
        if group["kind"] == "crank"
    }
    swinging = {f"phi{number}" for number in re.findall(r'^w(\d+) = "swing', Path("mine.toml").read_text(encoding="utf-8"), re.M)}
    for angle, range_of_it in turned.items():
        assert range_of_it == pytest.approx(1.2 if angle in swinging else 2 * np.pi, rel=0.01)
    assert not swinging or "PRP" in kinds  # only a guide on the crank itself makes it swing


def test_the_page_of_a_chain_is_written(folder):
    written(("crank", "RPR", "RRP"))
    ran = call("run", "mine", "--format", "html,csv")
    assert ran.exit_code == 0, ran.output
    assert (folder / "coursework-mine" / "invariants.csv").exists()


@pytest.mark.long
@pytest.mark.parametrize("language", ["en", "ru", "uk", "zh"])
def test_every_key_has_a_comment_in_the_language_asked(language):
    text = written(("crank", "RRR", "PRP", "RPP", "RPR", "RRP"), "--language", language)
    keys = [line for line in text.splitlines() if re.match(r"\w+ *= (?!\[$)|\[|    \{", line)]
    assert all(" # " in line for line in keys), [line for line in keys if " # " not in line]
    said = load_phrases(language).said
    assert f"# {said('new.change_data')}\n# {said('new.change_groups')}\n" in text
    data = tomllib.loads(text)
    assert {key for group in data["group"] for key in group} == {
        "kind", "from", "meets", "lengths", "coordinates", "mode", "guide", "guides", "offset", "angle",
    }  # fmt: skip


def test_comments_name_the_points_of_the_file():
    text = written(("crank", "RRR"))
    assert "# B: the known point that the first link hangs on; C: the one that the second link hangs on" in text
    assert "# +1: D to the left of the ray from B to C; -1: D to its right" in text


@pytest.mark.long
def test_the_same_kinds_give_the_same_file():
    first = written(("crank", "RRR", "RPR"))
    Path("mine.toml").unlink()
    assert written(("crank", "rrr", "rpr")) == first


def test_two_cranks_drive_one_dyad():
    data = tomllib.loads(written(("crank", "crank", "RRR")))
    assert data["group"][2]["from"] == [data["group"][0]["meets"], data["group"][1]["meets"]]
    assert set(data["drive"]) == {"w1", "w2"}


@pytest.mark.parametrize(
    ("groups", "more", "told"),
    [
        ("crank,RRQ,XX", (), 'C071 --groups: there is no kind "RRQ", "XX". Did you mean "RRR"? Kinds: crank, RRR,'),
        ("crank,rrq", (), 'no kind "rrq". Did you mean "RRR"?'),
        ("crnk,RRR", (), 'no kind "crnk". Did you mean "crank"?'),
        ("RRR,crank", (), "C072 --groups: 2 to 20 kinds with commas between, a crank first, were expected (found RRR, crank)."),
        ("crank", (), "(found crank). Write --groups crank,RRR."),
        ("", (), "(found nothing)"),
        (",".join(["crank"] + ["RPP"] * 20), (), "2 to 20 kinds"),
        ("crank,RRR", ("--from", "31"), "C070 --groups writes a chain of its own, --from copies a variant"),
        ("crank,RRR", ("--set", "r1=1m"), "C045 --set changes a copy"),
    ],
)
def test_what_makes_no_chain_is_refused_in_one_message(groups, more, told):
    result = call("new", "mine", "--groups", groups, *more)
    assert result.exit_code == 2
    assert told in result.stderr
    assert result.stderr.count("\n") == 1
    assert not Path("mine.toml").exists()


def test_a_group_that_never_closes_is_told_by_its_number_and_kind(monkeypatch):
    """Nothing is sound by more than 1, so that no dimensions of a dyad are."""
    monkeypatch.setattr(candidates, "_SOUND", 1.01)
    told = "C073 no dimensions were found in which group 2 (RRP) closes for the whole turn. Take the groups in another order."
    result = call("new", "mine", "--groups", "crank,rrp,RPP")
    assert (result.exit_code, told in result.stderr, Path("mine.toml").exists()) == (2, True, False), result.output


@pytest.mark.long
def test_as_many_groups_as_are_allowed_run():
    written(("crank", *["RPP", "RRP"] * 9, "RPP"))
    assert coursework.solve("mine", quantities=["table"]).stop is None


def test_the_help_has_one_table_of_all_kinds():
    shown = call("new", "--help").stdout
    for kind in ("crank", *DYADS):
        assert len(re.findall(rf"^  {kind} ", shown, re.M)) == 1
    assert "coordinates  angle of the rod; slide from D along the rod to B" in shown
    assert shown.count("        mode ") == 3
    russian = call("new", "--language", "ru", "--help").stdout
    assert "шатун и ползун на направляющей" in russian


KIND = """
from dataclasses import replace
from coursework.mechanism import groups
from coursework.mechanism.groups.rrp import RRP
from coursework.variant.record import vocabulary
vocabulary.GROUP_KINDS["LIFT"] = 1
groups.GROUPS = (*groups.GROUPS, replace(RRP, name="LIFT"))
from tests.command import call
print(call("new", "--help").stdout)
print(call("new", "lift", "--groups", "crank,LIFT").output)
import coursework
print(coursework.solve("lift").stop)
"""


def test_a_new_kind_is_in_the_table_and_in_files_by_itself(folder):
    root = Path(__file__).parents[2]
    done = subprocess.run(
        [sys.executable, "-c", KIND], capture_output=True, text=True, encoding="utf-8", check=False, cwd=folder,
        env=os.environ | {"PYTHONPATH": str(root)},
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert "\n  LIFT    a rod, and a slider on a guide\n" in done.stdout
    assert done.stdout.rstrip().endswith("None")


def test_help_speaks_the_language_asked_wherever_that_stands():
    for arguments in (["--help", "--language", "ru"], ["--language=ru", "--help"], ["-h", "--language=ru"]):
        assert "шарнир между ползунами" in call("new", *arguments).output
