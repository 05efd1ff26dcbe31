"""What the desk says of a text: the very report of `run`, the very sentences of `check`."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from coursework.api import solve
from coursework.desk.answering import variant_page
from coursework.desk.answering.mends import mends_of
from coursework.desk.answering.typed import Desk, faults_of
from coursework.desk.job import Policy, Setup
from coursework.equations.reduction import structure
from coursework.equations.reduction.equations import differentiate
from coursework.report.output.results import Results
from coursework.report.pages.html import render_html
from coursework.system.processes.budget import Budget
from coursework.variant.reading.reader import parse_variant
from coursework.words.errors import Fault, InputError
from coursework.words.sentences import say
from tests.command import call
from tests.desk.desks import TEXT, VARIANTS, desk
from tests.equations.test_nearly_dependent import two


@pytest.fixture
def client(tmp_path: Path):
    with desk(tmp_path) as opened:
        yield opened


def test_the_page_is_the_report_of_run(client):
    answer = client.post("/api/page", json={"text": TEXT, "name": "31"})
    run = solve(parse_variant(TEXT, "31"))
    results = Results(run, live=True)
    results.compute(pages=True)
    found = answer.json()
    assert (answer.status_code, found["faults"]) == (200, [])
    assert found["summary"] == run.summary
    assert found["page"] == render_html(results.model, pack=False)
    sliders = {one["name"]: (one["low"], one["high"], one["step"]) for one in found["data"]}
    assert sliders["r1"] == (0.476, 1.43, 0.001)  # from half of it to half as much again, outwards to its own last digit
    assert sliders["V1"] == (2.25, 6.75, 0.01)  # of 4.5: fifty places at least
    assert sliders["phi1"] == (-1.52, 4.78, 0.01)  # half a turn to each side


def test_what_failed_is_called_by_its_code_in_english_and_by_its_name_elsewhere(client):
    summaries = [client.post("/api/check", json={"text": two(1e-12), "language": one}).json()["summary"] for one in ("en", "uk")]
    assert ["CONDITION" in one for one in summaries] == [True, False]


def test_what_comes_into_view_later_is_left_out_until_it_is_asked_for(client):
    found = client.post("/api/page", json={"text": TEXT, "study": False}).json()
    whole = client.post("/api/page", json={"text": TEXT}).json()
    assert found["later"] == ["graph_check", "conclusion", "checks", "accuracy", "method"]
    assert whole["later"] == []
    lean, full = (re.findall(r'<section id="(\w+)">\s*(.*?)</section>', one["page"], re.S) for one in (found, whole))
    heads = [[(name, re.search("<h2>.*?</h2>", text)[0]) for name, text in parts] for parts in (lean, full)]
    assert heads[0] == heads[1]
    assert [name for name, text in lean if re.fullmatch(r"<h2>.*?</h2>\s*", text)] == found["later"]


@pytest.mark.long
def test_a_page_is_written_again_where_something_on_it_is_another(client, monkeypatch):
    written = []
    monkeypatch.setattr(variant_page, "render_html", lambda model, **how: written.append(model) or render_html(model, **how))
    text, other = TEXT.replace("0.953 m", "0.9531 m"), TEXT.replace("0.953 m", "0.9532 m")
    pages = [
        client.post("/api/page", json={"text": one, **more}).json()["page"]
        for one, more in (
            (text, {}),
            (text + "# a remark\n", {}),
            (other, {}),
            (text, {}),
            (text, {"language": "ru"}),
            (text, {"step": "h/2"}),
        )
    ]
    assert len(written) == 4
    assert pages[0] == pages[1] == pages[3]
    assert len(set(pages)) == 4


def test_scheme_and_step_are_those_of_the_command_line(client):
    found = client.post("/api/page", json={"text": TEXT, "scheme": "rk4", "step": "h/2", "language": "ru"}).json()
    assert 'lang="ru"' in found["page"]
    assert "Рунге" in found["page"]
    (fault,) = client.post("/api/check", json={"text": TEXT, "scheme": "rk5"}).json()["faults"]
    assert (fault["code"], fault["line"], fault["mend"]) == ("C003", None, None)


@pytest.mark.parametrize(
    ("right", "wrong", "code", "mended"),
    [
        ('start = "3.37 rad"', 'start = "3.37 rd"', "V109", "rad"),
        ("cos(phi2)", "cos(ph2)", "V053", "phi2"),
        ("[coordinates]", "[coordinate]", "V01", "coordinates"),
        ("0.953 m", "0.953 kg", "V105", None),
        ("[given]", "[given", "V", None),
    ],
)
def test_faults_are_those_of_check_at_their_place(client, folder, right, wrong, code, mended):
    text = TEXT.replace(right, wrong, 1)
    assert text != TEXT
    Path("own.toml").write_text(text, encoding="utf-8")
    told = call("check", "own").output
    found = client.post("/api/check", json={"text": text, "name": "own"}).json()
    assert found["summary"] is None
    assert "page" not in found
    assert found["faults"][0]["code"].startswith(code)
    for each in found["faults"]:
        assert f"{each['code']} own.toml:{each['line']}" in told
        assert each["sentence"] in told
    if mended:
        mend = next(fault["mend"] for fault in found["faults"] if fault["mend"])
        line = text.split("\n")[mend["line"] - 1]
        assert line[: mend["column"] - 1] + mend["text"] + line[mend["end_column"] - 1 :] in TEXT.split("\n")


@pytest.mark.parametrize(
    ("right", "wrong"),
    [
        ('"0.953 m"', "0.953 m"),
        ('"0.953 m"', '"0,953 m"'),
        ('"0.953 m"', "0,953 m"),
        ('"0.953 m"', "“0.953 m”"),
        ('"13.08 1/s"', "13.08 1/s"),
        ('"V1*sin(p*t + alpha)"', "V1*sin(p*t + alpha)"),
        ('"φ2" = {', "φ2 = {"),
        ('"0.02 s"', '"0,02 s"'),
        ("sin(p*t + alpha)", "sin(p*t + alpha"),
        ("sin(p*t + alpha)", "sin(p*t + alpha))"),
        ("2*r3*w3*cos(phi3)", "2r3*w3*cos(phi3)"),
    ],
)
def test_a_line_is_written_as_its_fault_says(right, wrong):
    whole = TEXT.replace("phi2 = {", '"φ2" = {')
    text = whole.replace(right, wrong, 1)
    assert text != whole
    with pytest.raises(InputError) as told:
        parse_variant(text, "own")
    lines = text.split("\n")
    (mend,) = mends_of(told.value.faults, lines)
    line = lines[mend["line"] - 1]
    lines[mend["line"] - 1] = line[: mend["column"] - 1] + mend["text"] + line[mend["end_column"] - 1 :]
    assert "\n".join(lines) == whole


def test_a_section_that_is_missing_is_begun_at_the_end_of_the_text(client):
    text = 'format = 1\n[given]\nr = "1 m"'
    for _ in ("coordinates", "time"):
        faults = client.post("/api/check", json={"text": text}).json()["faults"]
        mend = next(fault["mend"] for fault in faults if fault["code"] == "V012")
        lines = text.split("\n")
        assert (mend["line"], mend["column"]) == (mend["end_line"], mend["end_column"]) == (len(lines), len(lines[-1]) + 1)
        text += mend["text"]
    assert [line for line in text.split("\n") if line.startswith("[")] == ["[given]", "[coordinates]", "[time]"]
    told = client.post("/api/check", json={"text": text}).json()["faults"]
    assert [(fault["code"], fault["mend"]["text"].split()[0]) for fault in told] == [("V072", "[[constraint]]")]


@pytest.mark.parametrize(("folder", "advice"), [("", "[ask]"), (".", "--budget 5")])
def test_what_costs_too_much_is_told_with_what_helps_on_this_desk(folder, advice):
    fault = Fault(say("fault.E001", limit="5", stage="x"), "own")
    (told,) = faults_of(InputError([fault]), Desk({}, "en", Setup(Budget(5, 512), folder=folder)))
    assert (told["code"], advice in told["sentence"]) == ("E001", True)


def mended(client, text: str, key: str = "faults") -> str:
    (mend,) = [one["mend"] for one in client.post("/api/check", json={"text": text}).json()[key]]
    return text + mend["text"]


def test_an_empty_text_begins_as_a_task_sheet_does(client):
    text, time = (fault["mend"]["text"] for fault in client.post("/api/check", json={"text": ""}).json()["faults"])
    assert time.startswith("[time]")
    text = mended(client, text)
    assert [line for line in text.split("\n") if line.startswith("[")] == ["[given]", "[drive]", "[coordinates]", "[time]"]
    assert client.post("/api/check", json={"text": text}).json()["faults"][0]["code"] == "V072"  # no other fault in it


def test_what_a_text_lacks_yet_is_begun_by_a_click(client):
    whole = TEXT.partition("# --- geometry")[0]
    last = whole.rindex("[[constraint]]")
    assert "[[constraint]]" in mended(client, whole[:last])[last:]  # fewer equations than velocities
    text = mended(client, whole, "remarks")
    assert "[points]" in text[len(whole) :]
    text = mended(client, text.replace('A = "(0, 0)"', 'M = "(0, 0)"'), "remarks")
    assert text.endswith('[closure]\ndriven = "M"\nholds  = []\n')
    assert client.post("/api/check", json={"text": TEXT}).json()["remarks"] == []


def test_a_faulty_text_has_no_page(client):
    found = client.post("/api/page", json={"text": ""}).json()
    assert (found["page"], found["summary"], len(found["faults"]) > 0) == (None, None, True)


def test_tables_are_those_sent_then_those_of_the_folder_then_the_catalogues(client, tmp_path):
    name = next(path.stem for path in sorted(VARIANTS.glob("*.toml")) if "table = " in path.read_text(encoding="utf-8"))
    text = (VARIANTS / f"{name}.toml").read_text(encoding="utf-8")
    table = text.partition('table = "')[2].partition('"')[0]
    assert client.post("/api/check", json={"text": text}).json()["faults"] == []
    (tmp_path / table).write_text("1,2\n", encoding="utf-8")
    assert client.post("/api/check", json={"text": text}).json()["faults"]
    whole = (VARIANTS / table).read_text(encoding="utf-8")
    assert client.post("/api/check", json={"text": text, "tables": {table: whole}}).json()["faults"] == []


def test_a_department_may_keep_the_exact_motion_to_itself():
    with desk(policy=Policy(exact=False)) as client:
        (fault,) = client.post("/api/check", json={"text": TEXT, "scheme": "exact"}).json()["faults"]
        assert (fault["code"], fault["sentence"]) == ("C087", "this desk does not offer exact.")
        chain = (VARIANTS / "v101.toml").read_text(encoding="utf-8")
        assert client.post("/api/check", json={"text": chain}).json()["faults"] == []


@pytest.mark.parametrize(
    ("body", "status"),
    [
        (b"{", 400), (b"[" * 100_000, 400), (b"\xff", 400), (b"[]", 422), (b"{}", 422), (b'{"text": 5}', 422),
        (b'{"text": "", "tables": []}', 422), (b'{"text": "", "tables": {"a": 1}}', 422), (b'{"text": "\\ud800"}', 422),
        (b'{"text": "", "txt": ""}', 422), (b'{"text": null}', 422), (b'{"text": "", "step": 0.02}', 422),
        (b'{"text": "' + b"x" * 10**6 + b'"}', 413), (b'{"text": "", "step": null}', 200),
    ],
)  # fmt: skip
def test_other_shapes_are_refused_with_their_status(client, body, status):
    answer = client.post("/api/page", content=body)
    assert answer.status_code == status
    assert status == 200 or answer.json()["sentence"].endswith(".")


def test_other_numbers_compile_no_structure_again(client, monkeypatch):
    made = []
    monkeypatch.setattr(structure, "differentiate", lambda mechanism: made.append(mechanism) or differentiate(mechanism))
    structure.structures.cache_clear()
    for number in range(2):
        for name in ("31", "v101"):
            text = (VARIANTS / f"{name}.toml").read_text(encoding="utf-8").replace("4.5 m/s", f"4.{number} m/s")
            assert client.post("/api/check", json={"text": text + f"\n# {number}\n"}).json()["faults"] == []
    assert len(made) == 2
    scenes = [solve(parse_variant(TEXT.replace("0.953 m", f"0.95{number} m"))).scene for number in range(2)]
    assert scenes[0].solutions is scenes[1].solutions
    assert structure.structures.cache_info().maxsize >= 32
