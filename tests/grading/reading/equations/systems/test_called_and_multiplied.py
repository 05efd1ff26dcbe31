"""Functions with letters of their own, dot products, a minus before what solves, columns of lists: right read as right.

Each has neighbours that are wrong; none of them may pass as the whole set.
"""

from __future__ import annotations

import pytest

from tests.grading.reading.equations.notation.test_notations import marked

FIRST = "w3 = VMy/(r3*(2*cos(phi3) + sin(phi3)))\nw4 = 2*w3*(cos(phi3) - 2*sin(phi3))\n"
K = "r3*w3*sin(phi3)"
MATRIX = "[r1*sin(phi1), r2*sin(phi2); r1*cos(phi1), r2*cos(phi2)]"
SYSTEM = f"{FIRST}A = {MATRIX};\n"
# Variant, a right text, what a slip makes of a piece of it.
FORMS: dict[str, tuple[str, str, list[tuple[str, str]]]] = {
    "a matrix of letters": ("v105", """A = @(x, y, m, n) [m*sin(x) n*sin(y); m*cos(x) n*cos(y)];
b = [-VMx; VMy];
w12 = A(phi1, phi2, r1, r2) \\ b;
w34 = A(phi3, phi4, r3, r4) \\ b;
w1 = w12(1); w2 = w12(2); w3 = w34(1); w4 = w34(2);""",
        [("phi4, r3, r4", "phi4, r4, r3"), ("n*cos(y)]", "-n*cos(y)]"), ("A(phi3, phi4", "A(phi4, phi3")]),
    "a lambda": ("31", FIRST + """g = lambda x: 2*cos(x) + sin(x)
w1 = -r3*w3*sin(phi3)*g(phi2)/(r1*sin(phi1 - phi2))
w2 = r3*w3*sin(phi3)*g(phi1)/(r2*sin(phi1 - phi2))""",
        [("2*cos(x) +", "2*cos(x) -"), ("g(phi2)", "g(phi1)"), ("g(phi1)/", "g(phi1 + phi2)/")]),
    "a function of Mathematica": ("31", FIRST + """g[x_] := 2 Cos[x] + Sin[x]
w1 = -r3 w3 Sin[phi3] g[phi2]/(r1 Sin[phi1 - phi2])
w2 = r3 w3 Sin[phi3] g[phi1]/(r2 Sin[phi1 - phi2])""",
        [("2 Cos[x] +", "2 Cos[x] -"), ("g[phi2]", "g[phi1]"), ("w2 = r3", "w2 = -r3")]),
    "a product without a sign": ("31", FIRST + """g = @(a) 2cos(a) + sin(a);
w1 = -r3*w3*sin(phi3)*g(phi2)/(r1*sin(phi1 - phi2))
w2 = r3*w3*sin(phi3)*g(phi1)/(r2*sin(phi1 - phi2))""",
        [("2cos(a) +", "2cos(a) -"), ("g(phi2)", "g(phi1)"), ("w2 = r3", "w2 = 2*r3")]),
    "def and return": ("31", FIRST + """def g(x):
    return 2*cos(x) + sin(x)
w1 = -r3*w3*sin(phi3)*g(phi2)/(r1*sin(phi1 - phi2))
w2 = r3*w3*sin(phi3)*g(phi1)/(r2*sin(phi1 - phi2))""",
        [("return 2*cos(x)", "return cos(x)"), ("g(phi2)", "g(phi3)"), ("w1 = -", "w1 = ")]),
    "an arrow": ("31", FIRST + f"""g := (x, y) -> {K}*(2*cos(x) + sin(x))/y;
w1 := -g(phi2, r1*sin(phi1 - phi2));
w2 := g(phi1, r2*sin(phi1 - phi2));""",
        [("g(phi2, r1", "g(phi2, r2"), ("w1 := -g", "w1 := g"), ("r2*sin(phi1 - phi2)", "r2*sin(phi1 + phi2)")]),
    "a dot product": ("v101", """w3 = (VMy*cos(beta) - VMx*sin(beta))/((a + c)*cos(phi3 - beta))
vC = [VMx + (a + c)*w3*sin(phi3); VMy - (a + c)*w3*cos(phi3)];
e = [cos(beta); sin(beta)];
w4 = -(vC.'*e)/R
r1*w1*sin(phi1) + r2*w2*sin(phi2) = -VMx - a*w3*sin(phi3)
r1*w1*cos(phi1) + r2*w2*cos(phi2) = VMy - a*w3*cos(phi3)""",
        [("e = [cos(beta); sin", "e = [cos(beta); -sin"), ("w4 = -(vC", "w4 = (vC"),
         ("e = [cos(beta); sin", "e = [cos(beta); 2*sin")]),
    "dot(…)": ("v110", """w3 = VMy/((a + c)*cos(phi3))
uC = VMx + (a + c)*w3*sin(phi3)
n = np.array([-np.sin(beta), np.cos(beta)])
tau = np.array([np.cos(beta), np.sin(beta)])
vB = np.array([VMx + a*w3*np.sin(phi3), VMy - a*w3*np.cos(phi3)])
eA = np.array([np.sin(phi2), -np.cos(phi2)])
w2 = -np.dot(vB, n)/(r2*np.dot(eA, n))
uA = vB @ tau + r2*w2*(eA @ tau)""",
        [("w2 = -np", "w2 = np"), ("np.dot(eA, n)", "np.dot(eA, tau)"), ("(eA @ tau)", "(eA @ n)")]),
    "-A\\b": ("31", f"{SYSTEM}b = [2*{K}; -{K}];\nw = -A\\b;\nw1 = w(1); w2 = w(2);",
        [("w = -A", "w = A"), ("; -r3", "; r3"), ("b = [2", "b = [-2")]),
    "-inv(A) @ b": ("31", f"{SYSTEM}b = np.array([2*{K}, -{K}])\nw1, w2 = -np.linalg.inv(A) @ b",
        [("w1, w2 = -np", "w1, w2 = np"), ("w1, w2", "w2, w1"), ("[2", "[-2")]),
    "-solve(A, b)": ("31", f"{SYSTEM}b = np.array([2*{K}, -{K}])\nw1, w2 = -np.linalg.solve(A, b)",
        [("w1, w2 = -np", "w1, w2 = np"), ("w1, w2", "w2, w1"), ("[2", "[-2")]),
    "inv(A) @ b returned": ("robot-arm", """J = np.array([[-r1*sin(phi1), -r2*sin(phi2)], [r1*cos(phi1), r2*cos(phi2)]])
return np.linalg.inv(J) @ np.array([VMx, VMy])""",
        [("[VMx, VMy]", "[VMy, VMx]"), ("[r1*cos", "[-r1*cos"), ("[VMx, VMy]", "[VMx, -VMy]")]),
    "a factor of a list": ("example-1", """m = {{-r2 Sin[θ2], r3 Sin[θ3]}, {r2 Cos[θ2], -r3 Cos[θ3]}};
rhs = w1 {r1 Sin[θ1], -r1 Cos[θ1]};
{w2, w3} = LinearSolve[m, rhs]""",
        [("rhs = w1", "rhs = -w1"), ("rhs = w1", "rhs = 2 w1"), ("-r1 Cos", "r1 Cos")]),
    "a factor in a drawing": ("example-1", """| -r2 sin(theta2)   r3 sin(theta3) |   | w2 |        |  r1 sin(theta1) |
|  r2 cos(theta2)  -r3 cos(theta3) | * | w3 | = w1 * | -r1 cos(theta1) |""",
        [("= w1", "= -w1"), ("= w1", "= 2*w1"), ("| -r1", "|  r1")]),
    "columns of Korea": ("example-2", """A열 = t, B열 = θ1, C열 = θ2, D열 = s3
w2 (E열): =-r1_*w0*COS(B5)/(r2_*COS(C5))
u3 (F열): =-r1_*w0*SIN(B5)-r2_*E5*SIN(C5)""",
        [("=-r1_*w0*COS(B5)", "=-r1_*w0*COS(C5)"), ("r2_*E5*SIN(C5)", "r2_*E5*SIN(B5)"),
         ("B열 = θ1, C열 = θ2", "B열 = θ2, C열 = θ1")]),
    "points of Mathcad": ("31", f"""{FIRST}M := ( r.1·sin(φ.1)  r.2·sin(φ.2) ; r.1·cos(φ.1)  r.2·cos(φ.2) )
B := ( −2·{K} ; {K} )
(ω.1 ; ω.2) := M^−1 · B""",
        [("( −2", "( 2"), ("(ω.1 ; ω.2)", "(ω.2 ; ω.1)"), ("r.2·cos(φ.2) )", "−r.2·cos(φ.2) )")]),
    "systeme": ("31", FIRST + r"""\[\systeme{r_1\omega_1\sin\varphi_1+r_2\omega_2\sin\varphi_2=-2r_3\omega_3\sin\varphi_3,
r_1\omega_1\cos\varphi_1+r_2\omega_2\cos\varphi_2=r_3\omega_3\sin\varphi_3}\]""",
        [("=-2r_3", "=2r_3"), ("=r_3", "=-r_3"), (r"\varphi_2=-", r"\varphi_3=-")]),
    "cases of plain TeX": ("example-2", r"$$\cases{r_1\omega_1\cos\theta_1+r_2\omega_2\cos\theta_2=0\cr "
        r"u_3=-r_1\omega_1\sin\theta_1-r_2\omega_2\sin\theta_2\cr}$$",
        [("+r_2", "-r_2"), ("-r_1", "-2r_1"), (r"-r_2\omega_2\sin\theta_2", r"-r_2\omega_2\sin\theta_1")]),
    "a brace below a matrix": ("robot-arm", r"""\[\underbrace{\begin{bmatrix}-r_1\sin\varphi_1&-r_2\sin\varphi_2\\
r_1\cos\varphi_1&r_2\cos\varphi_2\end{bmatrix}}_{\mathbf{J}}\begin{bmatrix}\omega_1\\\omega_2\end{bmatrix}
=\underbrace{\begin{bmatrix}V_{Mx}\\V_{My}\end{bmatrix}}_{\text{given}}\]""",
        [("&-r_2", "&r_2"), (r"\omega_1\\\omega_2", r"\omega_2\\\omega_1"), (r"V_{My}\end", r"-V_{My}\end")]),
    "a named matrix times vectors": ("robot-arm", r"""$\mathbf{J}=\begin{bmatrix}-r_1\sin\varphi_1&-r_2\sin\varphi_2\\
r_1\cos\varphi_1&r_2\cos\varphi_2\end{bmatrix}$
$\mathbf{J}\begin{bmatrix}\omega_1\\\omega_2\end{bmatrix}=\begin{bmatrix}V_{Mx}\\V_{My}\end{bmatrix}$""",
        [("&-r_2", "&r_2"), (r"\omega_1\\\omega_2", r"\omega_2\\\omega_1"), (r"V_{My}\end", r"-V_{My}\end")]),
}  # fmt: skip


@pytest.mark.parametrize("form", FORMS)
def test_a_right_form_is_right_and_none_of_its_wrong_neighbours_is(form: str) -> None:
    name, text, slips = FORMS[form]
    found = marked(text, name)
    assert (found.share, len(found.wrong)) == (1.0, 0), [(mark.verdict, mark.line.text) for mark in found.marks]
    for piece, slip in slips:
        assert piece in text and marked(text.replace(piece, slip, 1), name).share < 1.0, (piece, slip)


def test_a_function_of_time_in_a_loop_of_euler_stays_what_it_is() -> None:
    loop = "def f(t, y):\n    return w3\ny = y + h*f(t, y)\ny = y + h*f(t + h, y)"
    assert marked(FIRST + loop).independent == marked(FIRST).independent
