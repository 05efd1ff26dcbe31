"""Strategies: formulas as trees, as text, and as text with something wrong in it."""

from hypothesis import strategies as st

from coursework.variant.formula.tree import FUNCTIONS, Formula

NAMES = {"a": 0.7, "b": 1.3, "phi1": 0.4, "w_3": 2.1}
VECTORS = {"P": (0.3, -1.2), "Q1": (2.0, 0.5)}

_numbers = st.one_of(
    st.integers(0, 999).map(str),
    st.floats(0.001, 999).map(lambda x: f"{x:.6g}"),
    st.sampled_from(["1e-3", "2.5E+2", ".5", "3.", "0"]),
).map(lambda text: Formula("number", name=text))
_names = st.sampled_from([*NAMES, "pi"]).map(lambda name: Formula("name", name=name))
_exponents = st.sampled_from(
    [
        Formula("number", name="2"),
        Formula("number", name="0.5"),
        Formula("neg", (Formula("number", name="1"),)),
        Formula("/", (Formula("number", name="1"), Formula("number", name="3"))),
    ]
)


def _wider(inner):
    one = [name for name, count in FUNCTIONS.items() if count == 1]
    return st.one_of(
        st.builds(lambda a: Formula("neg", (a,)), inner),
        st.builds(lambda op, a, b: Formula(op, (a, b)), st.sampled_from("+-*/"), inner, inner),
        st.builds(lambda a, b: Formula("^", (a, b)), inner, _exponents),
        st.builds(lambda name, a: Formula("call", (a,), name), st.sampled_from(one), inner),
        st.builds(lambda a, b: Formula("call", (a, b), "atan2"), inner, inner),
    )


def _vectors(scalars):
    def wider(inner):
        return st.one_of(
            st.builds(lambda op, a, b: Formula(op, (a, b)), st.sampled_from("+-"), inner, inner),
            st.builds(lambda a, b: Formula("*", (a, b)), scalars, inner),
            st.builds(lambda a: Formula("neg", (a,)), inner),
        )

    leaves = st.one_of(
        st.sampled_from([*VECTORS]).map(lambda name: Formula("name", name=name)),
        st.builds(lambda a, b: Formula("@", (a, b)), scalars, scalars),
        st.builds(lambda a, b: Formula("pair", (a, b)), scalars, scalars),
    )
    return st.recursive(leaves, wider, max_leaves=6)


scalar_trees = st.recursive(st.one_of(_numbers, _names), _wider, max_leaves=12)
vector_trees = _vectors(st.recursive(st.one_of(_numbers, _names), _wider, max_leaves=4))
parts = st.builds(lambda name, inner: Formula("part", (inner,), name), st.sampled_from("xy"), vector_trees)

WORDS = [
    *FUNCTIONS, *NAMES, "pi", "t", "tg", "ctg", "ω3", "φ₁", "соs", "lambda", "if", "else", "for", "in", "not", "__import__",
    "0", "1", "2.5", "1e9", "1e999", "1e-999", "9**9**9", "(", ")", "(", ")", "[", "]", "{", "}", "+", "-", "*", "/", "^",
    "**", "@",
    ",", ".", "=", ":=", "==", ":", ";", "'", '"', "\\", "#", "%", "!", "~", "|", "·", "−", "²", "√", " ", "\t", "\n",
    "\x00", "\u202e", "😀",
]  # fmt: skip
word_salad = st.lists(st.sampled_from(WORDS), max_size=40).map("".join)
any_text = st.one_of(st.text(max_size=60), word_salad)


@st.composite
def spoilt(draw, texts):
    """Return a good text with a few letters put in, taken out or changed."""
    text = draw(texts)
    for _ in range(draw(st.integers(1, 3))):
        place = draw(st.integers(0, len(text)))
        gone = draw(st.integers(0, 2))
        text = text[:place] + draw(st.sampled_from([*WORDS, ""])) + text[place + gone :]
    return text
