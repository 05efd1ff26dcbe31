"""Equations as the editors of Word and LibreOffice store them: each of variant 31's, in the shapes that people make with them."""

from __future__ import annotations

import pytest

from coursework.grading.marking.equations.equations import Judge
from coursework.grading.marking.key.key import key_of
from coursework.grading.reading.read_submission import read_submission
from coursework.grading.reading.student_work import StudentWork
from coursework.grading.reading.submission import Submission, submitted_file
from coursework.variant.catalogue import load
from tests.grading.reading.table.dialects import archive
from tests.grading.scenes import expected

JUDGE = Judge(key_of(load("31")))


def r(text: str) -> str:
    return f'<m:r><w:rPr><w:rFonts w:ascii="Cambria Math"/></w:rPr><m:t xml:space="preserve">{text}</m:t></m:r>'


def sub(body: str, index: str) -> str:
    return f"<m:sSub><m:sSubPr><m:ctrlPr/></m:sSubPr><m:e>{body}</m:e><m:sub>{index}</m:sub></m:sSub>"


def name(letter: str, index: str) -> str:
    return sub(r(letter), r(index))


def func(function: str, argument: str) -> str:
    upright = f'<m:r><m:rPr><m:sty m:val="p"/></m:rPr><m:t>{function}</m:t></m:r>'
    return f"<m:func><m:fName>{upright}</m:fName><m:e>{argument}</m:e></m:func>"


def frac(above: str, below: str) -> str:
    return f'<m:f><m:fPr><m:type m:val="bar"/></m:fPr><m:num>{above}</m:num><m:den>{below}</m:den></m:f>'


def d(body: str, begin: str = "(", end: str = ")") -> str:
    return f'<m:d><m:dPr><m:begChr m:val="{begin}"/><m:endChr m:val="{end}"/></m:dPr><m:e>{body}</m:e></m:d>'


def dot(body: str) -> str:
    return f'<m:acc><m:accPr><m:chr m:val="\u0307"/></m:accPr><m:e>{body}</m:e></m:acc>'


def math(*parts: str) -> str:
    return f"<m:oMathPara><m:oMath>{''.join(parts)}</m:oMath></m:oMathPara>"


R1, R2, R3 = (name("r", index) for index in "123")
W1, W2, W3, W4 = (name("ω", index) for index in "1234")
P1, P2, P3 = (name("φ", index) for index in "123")
FIRST = sub(r("V"), sub(r("M"), r("y"))) + r("−2") + R3 + W3 + func("cos", P3) + r("−") + R3 + W3 + func("sin", d(P3)) + r("=0")
SECOND = (
    r("2") + R3 + W3 + func("sin", P3) + r("−") + R3 + W3 + func("cos", P3) + r("+") + frac(r("1"), r("2")) + R3 + W4 + r("=0")
)
THIRD = (
    r("−0,5") + R3 + W4 + r("+") + R3 + W3 + func("cos", P3) + r("+") + R2 + W2 + func("sin", P2) + r("+") + R1 + dot(P1)
    + func("sin", P1) + r("=0#") + d(r("16"))
)  # fmt: skip
FOURTH = R3 + sub(dot(r("φ")), r("3")) + func("sin", P3) + r("-") + R2 + W2 + func("cos", P2) + r("-") + R1 + W1 + func("cos", P1)
SOLVED = W3 + r("=") + frac(name("V", "My"), R3 + d(r("2") + func("cos", P3) + r("+") + func("sin", P3), "[", "]"))
SYSTEM_ROWS = (FIRST, SECOND, FOURTH.replace("-", "&amp;-") + r("&amp;=0"))
SYSTEM = d("<m:eqArr>" + "".join(f"<m:e>{row}</m:e>" for row in SYSTEM_ROWS) + "</m:eqArr>", "{", "")
STYLED = (
    r("2")
    + name("𝑟", "3")
    + name("𝜔", "3")
    + func("sin", name("𝜑", "3"))
    + r("⋅1−")
    + R3
    + W3
    + func("cos", P3)
    + r("+0.5∙")
    + R3
    + W4
    + r("=0")
)
SQUARED = R3 + W3 + func("sin", P3) + r("=") + d(R2 + W2 + func("cos", P2) + r("+") + R1 + W1 + func("cos", P1)) + r("·") + d(
    f"<m:func><m:fName><m:sSup><m:e>{r('sin')}</m:e><m:sup>{r('2')}</m:sup></m:sSup></m:fName><m:e>{P2}</m:e></m:func>" + r("+")
    + f"<m:sSup><m:e>{d(func('cos', P2))}</m:e><m:sup>{r('2')}</m:sup></m:sSup>"
)  # fmt: skip


def word(*paragraphs: str) -> StudentWork:
    body = "".join(f"<w:p>{paragraph}</w:p>" for paragraph in paragraphs)
    return read("report.docx", {"word/document.xml": f'<w:document xmlns:w="w" xmlns:m="m"><w:body>{body}</w:body></w:document>'})


def read(file: str, parts: dict[str, str]) -> StudentWork:
    return read_submission(Submission("x", None, (submitted_file(file, archive(dict(parts))),)), expected())


def verdicts(work: StudentWork) -> list[str]:
    marks = JUDGE.mark(work.equations or ())
    assert marks.independent == len([mark for mark in marks.marks if mark.verdict in {"right", "rounded"}])
    return [mark.verdict for mark in marks.marks]


@pytest.mark.parametrize(
    "equation",
    [FIRST, SECOND, THIRD, FOURTH + r("=0"), SOLVED, STYLED, SQUARED],
    ids=["11", "12", "16", "18", "solved", "styled", "squared"],
)
def test_each_equation_as_word_stores_it(equation: str) -> None:
    text = "<w:r><w:t>Швидкість точки C дорівнює</w:t></w:r>"
    assert verdicts(word("<w:r><w:t>Title</w:t></w:r>", text + math(equation))) == ["right"]
    assert str(word(text, text + math(equation)).equations[0].where) == "paragraph 2"  # type: ignore[index]


def test_a_run_of_its_own_is_a_function_and_told_things_are_no_equations() -> None:
    runs = R3 + W3 + r("2") + r("sin") + P3 + r("=") + r("2") + R3 + W3 + r("sin") + d(P3)
    (line,) = word(math(SECOND), math(runs)).equations[1:]  # type: ignore[index]
    assert line.text.count(" sin ") == 2
    told = "Знайти ω1, ω2 та ω3 починаючи з моменту часу t = 0 до кінця"
    assert verdicts(word(math(SECOND), f"<w:r><w:t>{told}</w:t></w:r>", math(sub(dot(r("ω")), r("3")) + r("=") + W3 + R3))) == [
        "right"
    ]


def test_a_system_under_a_brace_and_equations_typed_in_part() -> None:
    assert verdicts(word(math(SYSTEM))) == ["right"] * 3
    assert verdicts(word(f"<m:oMath>{FOURTH}</m:oMath><w:r><w:t> = 0,   (18)</w:t></w:r>")) == ["right"]
    assert verdicts(word(f"<w:r><w:t>(11) </w:t></w:r>{math(FIRST)}<w:r><w:br/></w:r>{math(SECOND)}")) == ["right", "right"]


def run(text: str, position: str = "") -> str:
    properties = f'<w:rPr><w:vertAlign w:val="{position}"/></w:rPr>' if position else ""
    return f'<w:r>{properties}<w:t xml:space="preserve">{text}</w:t></w:r>'


def test_letters_set_lower_and_higher_and_the_symbol_font() -> None:
    third = run("3", "subscript")
    typed = (
        run("r")
        + third
        + run("ω")
        + third
        + run("sin")
        + run("2", "superscript")
        + run("φ")
        + third
        + run(" + r")
        + third
        + run("ω")
    )
    typed += third + run("cos") + run("2", "superscript") + run("φ") + third + run(" = w3·r3")
    work = word(typed)
    assert work.equations is not None and work.equations[0].tree is not None
    assert work.equations[0].text == "r3 ω3 sin^2φ3 + r3 ω3 cos^2φ3 = w3*r3"
    omega = '<w:r><w:sym w:font="Symbol" w:char="F077"/></w:r>'
    phi = '<w:r><w:sym w:font="Symbol" w:char="F06A"/></w:r>'
    other = '<w:r><w:sym w:font="Cambria Math" w:char="03C6"/></w:r>'
    fourth = (
        run("r3") + omega + run("3 sin ") + phi + run("3 - r2") + omega + run("2 cos ") + other + run("2 - r1*w1*cos(phi1) = 0")
    )
    assert verdicts(word(fourth)) == ["right"]


def test_what_is_deleted_hidden_twice_or_too_deep_says_nothing() -> None:
    gone = f"<w:del>{run('w3 = r1*w1')}</w:del>"
    twice = (
        f"<mc:AlternateContent><mc:Choice>{math(FIRST)}</mc:Choice><mc:Fallback>{math(FIRST)}</mc:Fallback></mc:AlternateContent>"
    )
    assert verdicts(word(gone + twice)) == ["right"]
    nested = W3 + r("=") + R1 + "".join(["<m:d><m:e>"] * 60) + W1 + "".join(["</m:e></m:d>"] * 60)
    assert verdicts(word(math(nested))) == ["unreadable"]
    long = W3 + r("=") + r("+").join([R1 + W1] * 3000)
    assert verdicts(word(math(long))) == ["unreadable"]


MATHML = (
    "<math:mrow><math:msub><math:mi>V</math:mi><math:mi>My</math:mi></math:msub><math:mo>−</math:mo><math:mn>2</math:mn>"
    "<math:msub><math:mi>r</math:mi><math:mn>3</math:mn></math:msub><math:msub><math:mover accent='true'><math:mi>φ</math:mi>"
    "<math:mo>˙</math:mo></math:mover><math:mn>3</math:mn></math:msub><math:mi>cos</math:mi><math:msub><math:mi>ϕ</math:mi>"
    "<math:mn>3</math:mn></math:msub><math:mo>−</math:mo><math:msub><math:mi>r</math:mi><math:mn>3</math:mn></math:msub>"
    "<math:mo>⋅</math:mo><math:msub><math:mi>ω</math:mi><math:mn>3</math:mn></math:msub><math:mi>sin</math:mi><math:mrow>"
    "<math:mo fence='true'>(</math:mo><math:msub><math:mi>ϕ</math:mi><math:mn>3</math:mn></math:msub>"
    "<math:mo fence='true'>)</math:mo></math:mrow><math:mo>=</math:mo><math:mn>0</math:mn></math:mrow>"
)
STARMATH = (
    "V_My - 2 r_3 %omega_3 cos %varphi_3 - r_3 %omega_3 sin %varphi_3 = 0",
    "2 cdot r_3 %omega_3 sin left( %varphi_3 right) - r_3 %omega_3 cos %varphi_3 + {1} over {2} r_3 %omega_4 = 0",
    '- 0,5 r_3 %omega_4 + r_3 %omega_3 cos %varphi_3 + r_2 %omega_2 sin %varphi_2 + r_1 dot %varphi_1 sin %varphi_1 = 0 ~ "(16)"',
    "stack{alignl r_3 %omega_3 sin %varphi_3 - r_2 %omega_2 cos %varphi_2 # - r_1 %omega_1 cos %varphi_1 = 0}",
    "%omega_3 = {V_{My}} over {r_3 times (2 cos %varphi_3 + sin %varphi_3)}",
    "r_3 %omega_3 {sin^2 %varphi_3 + cos^2 %varphi_3} = r_3 %omega_3 newline V_My = r_3 %omega_3 (2 cos %varphi_3 + sin %phi_3)",
)


def writer(*formulas: str) -> StudentWork:
    body = "".join(
        f'<text:p>Text <draw:frame><draw:object xlink:href="./Object {k}"/></draw:frame></text:p>' for k in range(len(formulas))
    )
    parts = {f"Object {k}/content.xml": f"<math:math xmlns:math='m'>{text}</math:math>" for k, text in enumerate(formulas)}
    content = f"<office:document-content><office:body><office:text>{body}</office:text></office:body></office:document-content>"
    return read("report.odt", {"mimetype": "application/vnd.oasis.opendocument.text", "content.xml": content, **parts})


def annotated(shown: str, typed: str) -> str:
    return f"<math:semantics>{shown}<math:annotation math:encoding='StarMath 5.0'>{typed}</math:annotation></math:semantics>"


def test_formulas_of_libreoffice() -> None:
    assert verdicts(writer(annotated(MATHML, "nobody reads this"))) == ["right"]
    letters = "".join(f"<math:mtext>{letter}</math:mtext>" for letter in "VMy")
    spelt = MATHML.replace("<math:msub><math:mi>V</math:mi><math:mi>My</math:mi></math:msub>", letters)
    assert verdicts(writer(annotated(spelt.replace("mi>cos</math:mi", "mtext>cos</math:mtext"), "nobody"))) == ["right"]
    assert verdicts(writer(*(annotated("<math:mrow/>", text) for text in STARMATH[:4]))) == ["right"] * 4
    assert verdicts(writer(annotated("<math:mrow/>", STARMATH[4]))) == ["right"]
    work = writer(annotated("<math:mrow/>", STARMATH[5]))
    assert work.equations is not None and all(line.tree is not None for line in work.equations)
    deep = "%omega_3 = " + "{" * 5000 + "r_3 %omega_4" + "}" * 5000
    assert verdicts(writer(annotated("<math:mrow/>", deep))) in (["unreadable"], [])


def test_equations_of_word_in_rtf() -> None:
    name = r"{\msSub{\me{\mr\mscr0\msty2 %s}}{\msub{\mr %s}}}"
    third = name % ("r", "3") + name % (r"\u969 ?", "3")
    angle = name % (r"\u966 ?", "3")
    text = (
        r"{\mmath{\*\moMathPara{\*\moMath"
        + name % ("V", "My")
        + r"{\mr \u8722 ?2}"
        + third
        + r"{\mfunc{\mfName{\mr cos}}{\me"
        + angle
    )
    text += (
        r"}}{\mr \u8722 ?}"
        + third
        + r"{\mfunc{\mfName{\mr sin}}{\me{\md{\mdPr{\mbegChr (}{\mendChr )}}{\me"
        + angle
        + r"}}}}{\mr =0}}}}\par"
    )
    content = (
        r"{\rtf1\ansi\ansicpg1251{\fonttbl{\f0\fcharset204 Arial;}}\pard\f0 \'d8\'e2\'e8\'e4\'ea\'b3\'f1\'f2\'fc "
        + text
        + r"\pard end\par}"
    )
    found = read_submission(Submission("x", None, (submitted_file("w.rtf", content.encode()),)), expected())
    assert verdicts(found) == ["right"]
