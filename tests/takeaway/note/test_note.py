"""The note in Word, OpenDocument and LaTeX: the page's digits, its formulas, its drawings, what refers to what."""

import io
import json
import re
import subprocess
import zipfile
from collections import Counter
from itertools import cycle, product
from xml.etree import ElementTree

import docx
import pypandoc
import pytest

from coursework.report.output.formats import formats_for
from coursework.report.text.parts import Checks, Claims, Equations, Figure, Panels, Table
from coursework.takeaway.note.formulas import WIDE, _places, latex_of, letters_wide
from coursework.takeaway.note.writer import LANGUAGES
from coursework.variant.catalogue import names
from tests.command import call
from tests.sample import first, sampled_pairs
from tests.takeaway.taken import results_of, taken

KINDS = ("docx", "odt", "tex")


def parts_of(name, language, *kinds):
    return [part for one in results_of(name, language).model.sections for part in one.parts if isinstance(part, kinds)]


def note(name, suffix, language):
    return taken(name, suffix, language)[f"report.{suffix}"]


def tree_of(name, suffix, language):
    """The note read back by pandoc."""
    command = [pypandoc.get_pandoc_path(), "-f", {"tex": "latex"}.get(suffix, suffix), "-t", "json"]
    return json.loads(subprocess.run(command, input=note(name, suffix, language), capture_output=True, check=True).stdout)


def found(node, kind):
    if isinstance(node, dict):
        if node.get("t") == kind:
            yield node["c"]
        node = [*node.values()]
    for one in node if isinstance(node, list) else ():
        yield from found(one, kind)


def letters(runs):
    """A cell of the page as a reader reads it."""
    if isinstance(runs, str):
        return squeezed(runs)
    return squeezed("".join(f"{run['v']}{run['s']}" if "v" in run else "".join(run.values()) for run in runs))


def squeezed(text):
    return re.sub(r"\s", "", text)


def signs(formula):
    """The letters, digits and signs of a formula, in whichever language and order it is written."""
    for command, sign in (
        ("\\overset{\\rightarrow}", ""),
        ("→", ""),
        ("\\partial", "∂"),
        ("\\frac{1}{2}", "½"),
        ("\\frac{1}", ""),
        ("dω/dt", "ω"),
        ("dv/dt", "v"),
    ):
        formula = formula.replace(command, sign)
    formula = COMMANDS.sub("", formula)
    for letter, name in GREEK.items():
        formula = re.sub(rf"\\{name}(?![a-z])", letter, formula)
    plain = formula.translate(str.maketrans("₀₁₂₃₄₅₆₇₈₉⁰¹²³⁴⁵⁶⁷⁸⁹−⁻ϕφᵗⁿ½", "01234567890123456789--φφtn2"))
    return Counter(re.findall(r"[^\W_]|[=+\-∂]", plain))


COMMANDS = re.compile(
    r"\\(?:begin|end)\{\w+\}(?:\{\w*\})?"
    r"|\\(?:frac|left|right|quad|angle|lbrack|rbrack|cdot|text|underline|sqrt|dot|ddot|mathring|operatorname)\b"
)
GREEK = {
    "α": "alpha", "β": "beta", "γ": "gamma", "δ": "delta", "ε": "varepsilon", "θ": "theta", "λ": "lambda", "μ": "mu", "ξ": "xi",
    "π": "pi", "ρ": "rho", "σ": "sigma", "τ": "tau", "φ": "varphi", "ψ": "psi", "ω": "omega", "Δ": "Delta", "Φ": "Phi",
    "Ψ": "Psi",     "η": "eta", "κ": "kappa", "ν": "nu", "χ": "chi", "ζ": "zeta", "Ω": "Omega", "Σ": "Sigma",
}  # fmt: skip


# The digits of a file are the same in every language: each file is read in one, the one with the widest tables in all.
READ = ("whitworth", "ru"), ("v107", "zh"), *zip(names(), cycle(LANGUAGES)), *product(["andrews-forces"], LANGUAGES)


@pytest.mark.parametrize(("name", "language"), first(2, dict.fromkeys(READ)))
def test_the_tables_of_word_have_the_digits_of_the_page(name, language):
    read = docx.Document(io.BytesIO(note(name, "docx", language)))
    wanted = parts_of(name, language, Table, Claims, Checks)
    assert len(read.tables) == len(wanted)
    pages = {tuple(tuple(letters(cell) for cell in row) for row in part.rows) for part in wanted if isinstance(part, Table)}
    written = {tuple(tuple(squeezed(cell.text) for cell in row.cells) for row in table.rows[1:]) for table in read.tables}
    assert pages <= written
    for part, table in zip(wanted, read.tables, strict=True):
        if isinstance(part, Table):  # a digit of Times is half as wide as letters are high, 57/1440 inch stand on either side
            digit = (4.5 if len(part.columns) <= 9 else 3.5) * 0.3528
            for column, one in zip(part.columns, table.columns, strict=True):
                longest = max(len(cell.text) * bool(re.fullmatch(r"[−\d.,]*", cell.text)) for cell in one.cells[1:])
                assert one.width.mm >= digit * longest + 2.0, (name, column.head)


@pytest.mark.parametrize(
    ("name", "suffix"), sampled_pairs(names(), KINDS, {("31", "docx"), ("v107", "odt"), ("walschaerts", "tex")})
)
def test_every_formula_of_the_page_is_there_and_reads_the_same(name, suffix):
    wanted = [item for part in parts_of(name, "en", Equations) for item in part.items]
    if suffix == "tex":
        text = note(name, suffix, "en").decode()
        assert "\\begin{array}{l}" not in text  # lines of a formula stand below each other's sign of equality
        read = re.findall(
            r"\\\[(.*?)\\\]|\\begin\{equation\}\\tag\{.*?\}(?:\\label\{\w+\})?\n(.*?)\n\\end\{equation\}", text, re.S
        )
        read = ["".join(one) for one in read]
    elif suffix == "odt":
        read = formulas_of_odt(note(name, suffix, "en"))
    else:
        read = [latex for _, latex in found(tree_of(name, suffix, "en"), "Math")]
    assert len(read) == len(wanted)
    for formula, item in zip(read, wanted, strict=True):
        assert signs(formula) == signs(item.text), (formula, item.text)


def formulas_of_odt(content):
    """What the formulas of an OpenDocument text show, in order."""
    with zipfile.ZipFile(io.BytesIO(content)) as archive:
        places = re.findall(r'<draw:object [^>]*xlink:href="(Formula-\d+)', archive.read("content.xml").decode())
        roots = [ElementTree.fromstring(archive.read(f"{place}/content.xml")) for place in places]
    for root in roots:
        assert not {*"".join(root.itertext())} & {*"_\u0307\u0308\u030a"}  # LibreOffice shows "¿", or a circle below the dot
        fences = [one.get("form") for one in root.iter() if one.get("stretchy") == "true" and one.get("form")]
        assert fences.count("prefix") <= fences.count("postfix")  # it repeats the left one
        for above in root.iter():
            for one in [*above]:
                is_one = above.tag.endswith("mfrac") and one is above[0] and "".join(one.itertext()).strip() == "1"
                if one.tag.endswith("annotation") or is_one:  # before brackets, where the page has a wide quotient
                    above.remove(one)
    return ["".join(root.itertext()) for root in roots]


@pytest.mark.parametrize(("language", "suffix"), sampled_pairs(LANGUAGES, KINDS, {("ru", "docx"), ("zh", "odt"), ("uk", "tex")}))
def test_the_table_of_the_motion_reads_back_in_every_format_and_language(suffix, language):
    (wanted,) = [part for part in parts_of("31", language, Table) if part.places]
    rows = [[letters(cell) for cell in row] for row in wanted.rows]
    if suffix == "tex":
        read = [[squeezed(re.sub(r"\\textbf|[{}$]|\\[()]", "", cell)) for cell in line.rpartition("\\endlastfoot")[2].split("&")]
                for line in re.split(r"\\\\(?= ?\n)", note("31", suffix, language).decode())]  # fmt: skip
        assert all(row in read for row in rows)
        return
    tables = [[[squeezed("".join(found_text(cell[4]))) for cell in row[1]] for row in table[4][0][3]]
              for table in found(tree_of("31", suffix, language), "Table")]  # fmt: skip
    assert rows in tables


def found_text(node):
    if isinstance(node, dict):
        if node.get("t") == "Str":
            yield node["c"]
            return
        node = [*node.values()]
    for one in node if isinstance(node, list) else ():
        yield from found_text(one)


@pytest.mark.parametrize(("name", "language"), [("31", "ru"), ("v107", "zh")])
def test_references_of_word_lead_to_what_is_there(name, language):
    with zipfile.ZipFile(io.BytesIO(note(name, "docx", language))) as archive:
        text = archive.read("word/document.xml").decode()
        names = archive.namelist()
        relations = archive.read("word/_rels/document.xml.rels").decode()
    marks = re.findall(r'<w:bookmarkStart [^>]*w:name="([^"]+)"', text)
    led = re.findall(r"(?:PAGE)?REF (\w+) ", text)
    assert len(marks) == len(set(marks)) and set(led) <= {*marks} and len(led) > 10
    captions = [part for part in parts_of(name, language, Table, Figure, Panels) if part.label]
    assert len(re.findall(r"\bSEQ \S+ \\\* ARABIC", text)) == len(captions)
    pictures = [*parts_of(name, language, Figure)] + [one for part in parts_of(name, language, Panels) for one in part.items]
    told = re.findall(r'<wp:docPr descr="([^"]*)"', text)
    assert all(told) and Counter(squeezed(one.alt) for one in pictures) <= Counter(squeezed(one) for one in told)
    assert text.count("svgBlip") == len(told)  # an SVG beside every PNG
    for identifier in re.findall(r'r:(?:embed|id)="([^"]+)"', text):
        target = re.search(rf'<Relationship\b(?=[^>]*\bId="{identifier}")[^>]*\bTarget="([^"]+)"', relations)
        assert target and (f"word/{target[1]}" in names or "://" in target[1])


@pytest.mark.parametrize(("name", "language"), sampled_pairs(names(), LANGUAGES, {("31", "ru"), ("v107", "zh")}))
def test_the_text_leads_to_each_drawing_and_each_table_before_it_stands(name, language):
    with zipfile.ZipFile(io.BytesIO(note(name, "docx", language))) as archive:
        text = archive.read("word/document.xml").decode()
    stands = {mark: text.index(f'w:name="{mark}"') for mark in re.findall(r'w:name="((?:figure|table)_\d+)"', text)}
    assert len(stands) == len([part for part in parts_of(name, language, Table, Figure, Panels) if part.label])
    assert [mark for mark, place in stands.items() if not 0 <= text.find(f"REF {mark} ") < place] == []


def test_styles_are_those_of_the_standard():
    read = docx.Document(io.BytesIO(note("31", "docx", "ru")))
    section = read.sections[0]
    margins = (section.left_margin, section.right_margin, section.top_margin, section.bottom_margin)
    assert [round(one.mm) for one in margins] == [30, 15, 20, 20]
    body = read.styles["Body Text"]
    assert (body.font.name, body.font.size.pt, body.paragraph_format.line_spacing) == ("Times New Roman", 14, 1.5)
    assert round(body.paragraph_format.first_line_indent.mm, 1) == 12.5
    heads = [(one.style.name, one.text) for one in read.paragraphs if one.style.name.lower().startswith("heading")]
    assert heads[0] == ("Heading Structural", "Введение") and ("Heading Structural", "Список использованных источников") in heads
    captions = {one.style.name: one.text for one in read.paragraphs if "Caption" in one.style.name}
    assert captions["Image Caption"].startswith("Рисунок") and captions["Table Caption"].startswith("Таблица")
    turned = [one for one in read.sections if one.orientation]
    assert len(turned) == 1 and turned[0].page_width > turned[0].page_height  # the sheet that is true to scale


@pytest.mark.parametrize(("name", "language", "suffix"), [("31", "ru", "docx"), ("v107", "en", "odt")])
def test_the_same_bytes_on_every_run(name, language, suffix):
    assert dict(formats_for("run")[suffix].write(results_of(name, language))) == taken(name, suffix, language)


@pytest.mark.usefixtures("folder")
def test_a_department_has_styles_of_its_own(folder):
    (folder / "looks").mkdir()
    own = docx.Document()
    own.styles["Normal"].font.name = "Courier New"
    own.sections[0].left_margin = docx.shared.Mm(41)
    own.save(folder / "looks/reference.docx")
    called = call("run", "v107", "--quantities", "table", "--format", "docx", "--templates", "looks", "--out", "taken")
    assert called.exit_code == 0, called.output
    read = docx.Document(folder / "taken/report.docx")
    added = read.styles["First Paragraph"]  # python-docx has none
    assert added.font.name is None and added.font.size is None and added.base_style.name == "Body Text"
    assert read.styles["Normal"].font.name == "Courier New" and round(read.sections[0].left_margin.mm) == 41
    assert "report.docx" in json.loads((folder / "taken/run.json").read_text(encoding="utf-8"))["files"]


@pytest.mark.usefixtures("folder")
def test_a_missing_package_is_told_with_the_line_that_installs_it(folder, monkeypatch):
    monkeypatch.setattr("coursework.system.extras.find_spec", lambda name: None)
    called = call("run", "31", "--quantities", "table", "--format", "csv,docx,tex", "--out", "taken")
    assert called.exit_code == 2 and [path.name for path in (folder / "taken").iterdir() if path.suffix == ".csv"] == [
        "table.csv"
    ]
    assert called.stderr.count("[note]") == 2


@pytest.mark.parametrize("suffix", KINDS)
def test_a_program_in_the_appendix_is_typed_line_by_line(suffix, tmp_path):
    call("run", "31", "--quantities", "table,listing", "--format", suffix, "--out", str(tmp_path))
    command = [pypandoc.get_pandoc_path(), "-f", {"tex": "latex"}.get(suffix, suffix), "-t", "plain", "--wrap=none"]
    read = subprocess.run(command, input=(tmp_path / f"report.{suffix}").read_bytes(), capture_output=True, check=True).stdout
    lines = [" ".join(line.replace("\xa0", " ").split()) for line in read.decode().splitlines()]
    program = call("listing", "31", "--language", "python").stdout.splitlines()
    assert {" ".join(line.split()) for line in program if line} <= {*lines}


def test_a_worked_formula_that_is_too_long_is_broken_before_a_sign_and_has_its_result_below():
    long = "x = 1.5 \\ & quad + " + " + ".join(["0.0415 dot cos(0.0401)"] * 6) + ' = "0.5"'
    for aligned, below in ((True, r"& = 0.5"), (False, r"\quad\text{=} 0.5")):
        (made,) = latex_of([f"& {long}"], ".", aligned=aligned).values()
        assert below in made and made.count("\\\\") == 3 and letters_wide(made) <= WIDE
    inner = "0.0415 slash 0.0401 + " * 6
    (made,) = latex_of([f"y = 2 + a cos(1.5 + arccos({inner} 1))"], ".", aligned=False).values()
    assert letters_wide(made) <= WIDE and made.count("\\\\") == 3 and "2\\\\\n\\quad + a\\cos" in made
    (short,) = latex_of(['& x = 1.5 \\ & quad + 0.0415 dot cos(0.0401) = "0.5"'], ".", aligned=True).values()
    assert short.count("\\\\") == 1 and letters_wide(short) < 30
    (held,) = latex_of(["& x = [2 (-3)^2 \\ & quad + cos(1)]"], ".", aligned=False).values()
    first, second = held.removeprefix("\\begin{array}{l}").split("\\\\")
    for line, sides in ((first, 2), (second, 1)):  # LibreOffice shows "¿" for a bracket without its other one
        assert line.count("\\left") == line.count("\\right") == sides and line.count("\\left.") + line.count("\\right.") == 1


@pytest.mark.parametrize(
    ("line", "before"),
    [
        ("x = \\frac{a + b}{c + 1} + d - e", ["+ d", "- e"]), ("x = \\left(a + b\\right) + c", ["+ c"]),
        ("x = (a + b) - c", ["+ b", "- c"]), ("x = - a + b", ["+ b"]), ("& \\quad + a - b", ["- b"]),
        ("x = a + " + "b" * WIDE + " - c", ["+ b"]), ("x = a + " + "b" * (WIDE - 4) + " - c", ["+ b", "- c"]),
        ("x = a + " + "b" * (WIDE - 3) + " - c", ["+ b"]),  # "x=a+" takes four letters of the line
    ],
)  # fmt: skip
def test_a_formula_may_go_on_below_before_a_sign_between_two_terms_that_no_brace_holds(line, before):
    found = _places(line)
    assert [line[place + 1 : place + 4] for _, place in found] == before
    assert all(depth == line[:place].count("(") - line[:place].count(")") for depth, place in found)


def test_the_two_tables_of_checks_have_a_title_that_keeps_to_them():
    styles = [one.style.name for one in docx.Document(io.BytesIO(note("31", "docx", "en"))).paragraphs]
    assert styles.count("Table Title") == 4  # the claims, and in the appendix the checks
