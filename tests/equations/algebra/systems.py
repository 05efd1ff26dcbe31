"""Random mechanisms as text: velocity equations of any functions, and chains of links with odd angles and lengths."""

from random import Random

HEAD = """[given]
a = "0.7{m}"
b = "1.3{m}"
c = "2.1{m}"
k = "0.3"
[points]
{points}
[drive]
V = "3*cos(t + 1)"
U = "{drive}"
[functions]
R = "{law}"
[coordinates]
f = {{ start = "0.3", rate = "w0" }}
g = {{ start = "0.9", rate = "w1" }}
s = {{ start = "0.4{m}", rate = "w2" }}
[time]
step = "0.01 s"
end = "0.5 s"
"""
DRIVES = ("2*sin(3*t) + 1", "a*t^2/a", "1 + exp(-k*t)", "cos(t)*sin(2*t)", "V/2")
SMOOTH = ("+", "-", "*", "*", "sin", "cos", "sin", "cos", "/", "^")
OTHERS = ("sqrt", "abs", "exp", "tan", "atan")
ANGLES = ("f", "g", "f + pi/2", "g - f", "f + k", "-g", "f + pi", "g - pi/2", "2*f", "f/2 + g", "pi/3 + f")
LENGTHS = ("a", "b", "c", "(a + b)", "s", "a/2", "(c - a)", "2*b", "R*a")


def formula(dice: Random, depth: int, ops: tuple[str, ...]) -> str:
    """Return a formula of data, coordinates and a function."""
    if depth == 0 or dice.random() < 0.2:
        return dice.choice(("a", "b", "c", "k", "f", "g", "s", "2", "3", "0.5", "pi/2", "R"))
    op, x, y = dice.choice(ops), formula(dice, depth - 1, ops), formula(dice, depth - 1, ops)
    match op:
        case "+" | "-" | "*":
            return f"({x} {op} {y})"
        case "/":
            return f"{x}/({y}*{y} + 1.25)"
        case "^":
            return f"({x})^{dice.choice((2, 3))}"
        case "sqrt":
            return f"sqrt(({x})^2 + {dice.choice(('1', 'a', '(b*b)'))}^2)"
        case "exp":
            return f"exp(-f*({x}))"
    return f"{op}({x})"


def system(seed: int) -> str:
    """Return five velocity equations, each with an unknown of its own and up to two others."""
    dice = Random(seed)
    ops = SMOOTH + (OTHERS if seed % 3 == 0 else ())
    law = dice.choice(("1", "a*cos(f)", "sin(g) + s", "sqrt(f^2 + 1)", "a + b*t"))
    text = HEAD.format(m="", points="", drive=dice.choice(DRIVES), law=law) + '[unknowns]\nw3 = "1"\nw4 = "1"\n'
    order = [f"w{place}" for place in range(5)]
    dice.shuffle(order)
    for name in order:
        terms = [f"{formula(dice, 2, ops)}*{name}"]
        terms += [f"{formula(dice, dice.choice((1, 2)), ops)}*{other}" for other in dice.sample(order, dice.randint(0, 2))]
        right = dice.choice(("V", "U", f"V*{formula(dice, 1, ops)}", f"U + {formula(dice, 1, ops)}"))
        text += f'[[constraint]]\nequation = "{" + ".join(terms)} = {right}"\n'
    return text


def chain(seed: int) -> str:
    """Return a closed chain of links whose angles and lengths are sums, parts and functions of coordinates."""
    dice = Random(seed)
    links = " + ".join(f"{dice.choice(LENGTHS)} @ ({dice.choice(ANGLES)})" for _ in range(dice.randint(2, 4)))
    points = f'P = "{links}"\nQ = "c @ (g) - (s, {dice.choice(LENGTHS)})"'
    law = dice.choice(("1", "cos(f)", "1 + sin(g)/2", "exp(-f)", "sqrt(f^2 + 1)"))
    text = HEAD.format(m=" m", points=points, drive="2*sin(3*t) + 1", law=law)
    other = dice.choice(("(c, s)", "Q", "(s, a) + b @ (f)"))
    return text + f'[[constraint]]\nclosure = "P = {other}"\n[[constraint]]\nequation = "w0 = U"\n'
