"""Each part of a formula as it comes out on a line: MathML, Word's, StarMath; what letters and signs of RTF become."""

from __future__ import annotations

from xml.etree import ElementTree

import pytest

from coursework.grading.reading.documents.formulas.formula_tree import FormulaNode, FormulaTree
from coursework.grading.reading.documents.formulas.mathml import text_of_mathml
from coursework.grading.reading.documents.formulas.omml import text_of_omml
from coursework.grading.reading.documents.formulas.starmath import text_of_starmath
from coursework.grading.reading.documents.office.odt import document_of_odt, is_odt
from coursework.grading.reading.documents.office.rtf import document_of_rtf
from coursework.grading.reading.documents.pdf.pdf_lines import PageLine, Word
from coursework.grading.reading.equations.systems.parts import parts_of
from coursework.grading.reading.files.archive import Archive
from coursework.grading.reading.limits import Room
from tests.grading.reading.table.dialects import archive


def tree(xml: str) -> FormulaNode:
    """A formula as the readers of documents collect it."""
    found = FormulaTree("")

    def walk(element: ElementTree.Element) -> None:
        found.begin(element.tag, dict(element.attrib))
        found.text(element.text or "")
        for child in element:
            walk(child)
            found.text(child.tail or "")
        found.end()

    walk(ElementTree.fromstring(xml))
    return found.top


def bare(text: str) -> str:
    """A formula without spaces, its rows apart."""
    return ";".join("".join(row.split()) for row in text.split("\n") if row.strip())


@pytest.mark.parametrize(
    ("xml", "meant"),
    [
        ("<msqrt><mi>r</mi><mo>+</mo><mn>1</mn></msqrt>", "sqrt(r+1)"),
        ("<mroot><mi>a</mi><mn>3</mn></mroot>", "(a)^(1/(3))"),
        ("<mroot><mi>a</mi><mn>2</mn></mroot>", "sqrt(a)"),
        ("<msubsup><mi>r</mi><mn>2</mn><mn>3</mn></msubsup>", "r_2^3"),
        ("<msup><mi>ω</mi><mrow><mi>n</mi><mo>+</mo><mn>1</mn></mrow></msup>", "ω^(n+1)"),
        ("<msup><mi>a</mi><mo>′</mo></msup>", "a'"),
        ("<msup><mn>30</mn><mo>∘</mo></msup>", "30°"),
        ("<mrow><msup><mi>cos</mi><mn>2</mn></msup><mi>φ</mi></mrow>", "cos^2φ"),
        ("<msub><mi>V</mi><mrow><mi>M</mi><mi>y</mi></mrow></msub>", "V_{My}"),
        ("<msub><mi>V</mi><mo>,</mo></msub>", "V"),
        ('<mfenced open="[" close="]" separators=";"><mi>a</mi><mi>b</mi></mfenced>', "(a;b)"),
        ('<mfenced open="|" close="|"><mi>a</mi></mfenced>', "abs(a)"),
        ("<mfenced><mi>a</mi><mi>b</mi></mfenced>", "(a,b)"),
        ("<mtable><mtr><mtd><mi>a</mi></mtd><mtd><mn>0,5</mn></mtd></mtr><mtr><mtd><mi>b</mi></mtd></mtr></mtable>", "[a,0.5;b]"),
        ("<mtable><mtr><mtd><mi>a</mi></mtd><mtd><mo>=1</mo></mtd></mtr><mtr><mtd><mi>b</mi></mtd></mtr></mtable>", "a=1;b"),
        (
            "<mrow><mo>{</mo><mtable><mtr><mtd><mi>a</mi></mtd></mtr><mtr><mtd><mi>b</mi></mtd></mtr></mtable></mrow>", "a;b",
        ),
        ("<mrow><mo>{</mo><mi>a</mi><mo>+</mo><mi>b</mi><mo>}</mo></mrow>", "{a+b}"),
        ('<mrow><mi>a</mi><mspace linebreak="newline"/><mi>b</mi><mspace/><mi>c</mi></mrow>', "a;bc"),
        ("<munder><mi>a</mi><mi>i</mi></munder>", "a"),
        ("<mrow><mphantom><mi>x</mi></mphantom><mi>a</mi></mrow>", "a"),
        ("<mover><mi>φ</mi><mo>˙</mo></mover>", "φ\u0307"),
        ("<mover><mi>V</mi><mo>→</mo></mover>", "V"),
        ('<semantics><mrow/><annotation encoding="StarMath 5.0">a over b</annotation></semantics>', "((a)/(b))"),
        ('<semantics><mi>c</mi><annotation encoding="StarMath 5.0">a over b</annotation></semantics>', "c"),
    ],
)  # fmt: skip
def test_parts_of_mathml(xml: str, meant: str) -> None:
    assert bare(text_of_mathml(tree(f"<math>{xml}</math>"))) == meant


@pytest.mark.parametrize(
    ("xml", "meant"),
    [
        ("<m><mr><e>a</e><e>=1</e></mr><mr><e>b=2</e></mr></m>", "a=1;b=2"),
        (
            '<d><dPr><begChr val="["/><endChr val="]"/></dPr><e><m><mr><e>a</e><e>0,5</e></mr><mr><e>b</e></mr></m></e></d>',
            "[a,0.5;b]",
        ),
        ("<eqArr><e>a=1</e><e>b=2</e></eqArr>", "a=1;b=2"),
        ("<sSubSup><e>r</e><sub>2</sub><sup>3</sup></sSubSup>", "r_2^3"),
        ("<sPre><sub>2</sub><sup>3</sup><e>r</e></sPre>", "r_2^3"),
        ("<rad><deg>3</deg><e>a</e></rad>", "(a)^(1/(3))"),
        ("<rad><deg/><e>a</e></rad>", "sqrt(a)"),
        ("<nary><e>a</e></nary>", "∑(a)"),
        ('<d><dPr><begChr val="|"/><endChr val="|"/></dPr><e>a</e></d>', "abs(a)"),
        ("<d><e>a</e><e>b</e></d>", "(a,b)"),
        ("<func><fName>sin</fName><e>(a)</e></func>", "sin(a)"),
        ("<func><fName>sin</fName><e>a(b)</e></func>", "sin(a(b))"),
        ("<func><fName>sin</fName><e>(a)(b)</e></func>", "sin((a)(b))"),
        ("<func><fName>sin</fName><e>(a</e></func>", "sin((a)"),
        ("<acc><e>a</e></acc>", "a"),
        ("<oMath>a<br/>b</oMath>", "a;b"),
    ],
)
def test_parts_of_words_equations(xml: str, meant: str) -> None:
    assert bare(text_of_omml(tree(f"<oMath>{xml}</oMath>"))) == meant


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("sqrt {a + b}", "sqrt(a+b)"),
        ("stack{a = 1 # b = 2}", "a=1;b=2"),
        ("a = 1 newline b = 2", "a=1;b=2"),
        ("{a over b", "((a)/(b))"),
        ("a sup 2 + b sub 3", "a^2+b_3"),
        ("dot %phi", "φ\u0307"),
        ('"text" = 3', "text=3"),
        ("} a", "a"),
        ("{" * 300 + "a", "…"),
    ],
)
def test_parts_of_starmath(text: str, meant: str) -> None:
    assert bare(text_of_starmath(text)) == meant


@pytest.mark.parametrize(
    ("written", "lines"),
    [
        (r"a\emdash b\~c\_d\{e\}\\\par f\u966?g {\uc2\u969??}h\line i\tab j\par", ["a-b c-d{e}\\", "fφg ωh", "i\tj"]),
        ("a\\\nb", ["a", "b"]),
        (r"r{\sub 3} x{\super 2} y\sub 1\nosupersub 2\v hidden", ["r3 x^2 y1 2"]),  # a digit behind an index is none of it
        (r"{\fonttbl{\f1\fcharset2 Symbol;}}{\f1 w}{\f1\'66} \'e9", ["ωφ é"]),
        (r"{\header no}{\*\unknown no}{\*\moMath {\mr a}{\msSub {\me r}{\msub 3}}}\par end", ["a r_3", "end"]),
        (r"\ansicpg99999 \'e9", ["é"]),
        (r"a\bin5 bcdefg", ["ag"]),
    ],
)
def test_letters_and_signs_of_rtf(written: str, lines: list[str]) -> None:
    document = document_of_rtf(f"{{\\rtf1\\ansi {written}}}".encode("latin-1"), Room(10, 10))
    assert [line.text for line in document.lines] == lines


def test_merged_cells_of_rtf_hold_what_begins_them() -> None:
    """Of three cells the second goes on from the first; below, the first goes on from above."""
    rows = r"\trowd\cellx1\clmrg\cellx2\cellx3\intbl a\cell\cell b\cell\row"
    rows += r"\trowd\clvmrg\cellx1\cellx2\cellx3\intbl\cell c\cell d\cell\row"
    document = document_of_rtf(f"{{\\rtf1{rows}\\pard e}}".encode(), Room(10, 10))
    assert [[[cell.text for cell in row] for row in table.rows] for table in document.tables] == [
        [["a", "a", "b"], ["a", "c", "d"]]
    ]
    assert [line.text for line in document.lines] == ["e"]


ODT = """<?xml version="1.0"?><office:document-content xmlns:office="urn:oasis:names:tc:opendocument:xmlns:office:1.0"
 xmlns:text="urn:oasis:names:tc:opendocument:xmlns:text:1.0" xmlns:style="urn:oasis:names:tc:opendocument:xmlns:style:1.0"
 xmlns:table="urn:oasis:names:tc:opendocument:xmlns:table:1.0" xmlns:math="http://www.w3.org/1998/Math/MathML">
<style:style style:name="T1"><style:text-properties style:text-position="sub 58%"/></style:style>
<style:style style:name="T2"><style:text-properties style:text-position="33% 58%"/></style:style>
<style:style style:name="T3"><style:text-properties style:text-position="-33% 58%"/></style:style>
<style:style style:name="T4"><style:text-properties style:text-position="super 58%"/></style:style>
<style:style style:name="T5"><style:text-properties style:text-position="0% 100%"/></style:style>
<office:body>{}</office:body></office:document-content>"""


def _span(style: str, text: str) -> str:
    return f'<text:span text:style-name="{style}">{text}</text:span>'


def _table(*rows: str, times: int = 1) -> str:
    made = (f'<table:table-row table:number-rows-repeated="{times}">{row}</table:table-row>' for row in rows)
    return f"<table:table>{''.join(made)}</table:table>"


def _cell(text: str, spanned: int = 1) -> str:
    return f'<table:table-cell table:number-columns-spanned="{spanned}"><text:p>{text}</text:p></table:table-cell>'


def _covered(count: int) -> str:
    return f'<table:covered-table-cell table:number-columns-repeated="{count}"/>'


FOUR = "".join(map(_cell, "pqrs"))


@pytest.mark.parametrize(
    ("body", "lines", "tables"),
    [
        ("<text:p>a<text:s/>b<text:tab/>c<text:line-break/>d</text:p>", ["a b\tc", "d"], []),
        ('<text:p>r<text:span text:style-name="T1">3</text:span> x<text:span text:style-name="T2">2</text:span></text:p>',
         ["r3 x^2"], []),
        ("<text:p><math:math><math:msub><math:mi>r</math:mi> <math:mn>3</math:mn></math:msub><o>x</o></math:math></text:p>",
         ["r_3"], []),
        *(
            (f"<text:p>a{_span(style, '2')} 3b</text:p>", [f"a{read} 3b"], [])
            for style, read in (("T1", "2"), ("T2", "^2"), ("T3", "2"), ("T4", "^2"), ("T5", "2"), ("T9", "2"))
        ),
        (f"<text:p>a{_span('T2', '2')} 3</text:p>", ["a^2 3"], []),
        (f"<text:p>a{_span('T2', _span('T3', '3') + '2')}</text:p>", ["a3^2"], []),
        ("<text:p>a<office:annotation><text:p>no</text:p></office:annotation>b</text:p>", ["ab"], []),
        ("<text:p>a<text:note>n<office:annotation>no</office:annotation>no</text:note>b</text:p>", ["ab"], []),
        ("<text:tracked-changes><text:p>no</text:p></text:tracked-changes>no<text:s/><text:h>a</text:h>no", ["a"], []),
        (_table(_cell("a") + _cell("b"), times=2), [], [[["a", "b"]] * 2]),
        (_table(_cell("a", spanned=3) + _covered(2) + _cell("b")), [], [[["a", "a", "a", "b"]]]),
        (_table(FOUR, _cell("a", spanned=2) + _covered(2) + _cell("b")), [], [[[*"pqrs"], [*"aarb"]]]),
        (_table(FOUR, _covered(3) + _cell("b")), [], [[[*"pqrs"], [*"pqrb"]]]),
        (
            "<table:table><table:table-row>"
            '<table:table-cell table:number-columns-spanned="2"><text:p>a</text:p></table:table-cell>'
            '<table:covered-table-cell/><table:table-cell><text:p>b</text:p></table:table-cell></table:table-row>'
            '<table:table-row><table:covered-table-cell/><table:table-cell table:number-columns-repeated="2"><text:p>c</text:p>'
            "</table:table-cell></table:table-row></table:table>",
            [], [[["a", "a", "b"], ["a", "c", "c"]]],
        ),
    ],
)  # fmt: skip
def test_letters_formulas_and_cells_of_opendocument(body: str, lines: list[str], tables: list[list[list[str]]]) -> None:
    packed = archive({"mimetype": "application/vnd.oasis.opendocument.text", "content.xml": ODT.format(body)})
    assert is_odt(Archive(packed))
    document = document_of_odt(Archive(packed), Room(10, 10))
    assert [line.text for line in document.lines] == lines
    assert [[[cell.text for cell in row] for row in table.rows] for table in document.tables] == tables


def test_two_equations_beside_each_other_on_a_page_of_a_pdf_stay_two() -> None:
    words = [
        Word("r1*w1", 0, 40),
        Word("=", 44, 50),
        Word("r2*w2", 54, 94),
        Word("w3", 120, 130),
        Word("=", 134, 140),
        Word("2*w1", 144, 170),
    ]
    assert parts_of(PageLine(words, 10).text) == ["r1*w1 = r2*w2", "w3 = 2*w1"]


@pytest.mark.parametrize("name", ["mfrac", "msub", "msup", "mroot"])
def test_a_pair_of_mathml_without_its_second_part_is_its_first_and_a_third_part_counts_for_nothing(name: str) -> None:
    one, two, three = (
        text_of_mathml(tree(f"<math><{name}>{''.join(f'<mi>{letter}</mi>' for letter in inside)}</{name}></math>")).strip()
        for inside in ("a", "ab", "abc")
    )
    assert one == "a"
    assert two == three != "ab"


def test_a_formula_deeper_than_sixty_braces_is_left_out():
    assert bare(text_of_starmath("{" * 60 + "x" + "}" * 60)) == "x" and text_of_starmath("{" * 61 + "x" + "}" * 61) == "…"


@pytest.mark.parametrize(("letters", "is_whole"), [(8000, True), (8001, False)])
def test_a_formula_is_read_up_to_8000_letters(letters: int, is_whole: bool) -> None:
    assert text_of_starmath("a" * letters).endswith("…") is not is_whole
