"""Right equations as students of many countries hand them in are right at first sight; with one slip none is.

Each form is of a class of its own, such as matrices of Typst, Cramer's rule, columns of a sheet named in words.
"""

from __future__ import annotations

import pytest

from tests.grading.reading.equations.notation.test_notations import marked

FIRST = "w3 = VMy/(r3*(2*cos(phi3) + sin(phi3)))\nw4 = 2*w3*(cos(phi3) - 2*sin(phi3))\n"
LAST = "r1*w1*sin(phi1) + r2*w2*sin(phi2) = -2*r3*w3*sin(phi3)\nr1*w1*cos(phi1) + r2*w2*cos(phi2) = r3*w3*sin(phi3)\n"
MATRIX = "[[r1*sin(phi1), r2*sin(phi2)], [r1*cos(phi1), r2*cos(phi2)]]"
RIGHT = "[-2*r3*w3*sin(phi3), r3*w3*sin(phi3)]"
SYSTEM = f"{FIRST}A = {MATRIX}\nb = {RIGHT}\n"
# Variant, text, what a slip makes of a piece of it.
FORMS: dict[str, tuple[str, str, str, str]] = {
    "c_i in TeX": ("31", r"""Mit $c_i=\cos\varphi_i$ und $s_i=\sin\varphi_i$ gilt
\begin{align} r_3(2c_3+s_3)\omega_3 &= V_{My}\\ \omega_4 &= 2\omega_3c_3-4\omega_3s_3\\
r_1s_1\omega_1+r_2s_2\omega_2 &= -2r_3s_3\omega_3\\ r_1c_1\omega_1+r_2c_2\omega_2 &= r_3\omega_3s_3 \end{align}""",
        "-4", "+4"),
    "s_φ": ("31", FIRST + r"""$r_1\omega_1 s_{\varphi_1} + r_2\omega_2 s_{\varphi_2} + 2r_3\omega_3 s_{\varphi_3} = 0$
$r_1\omega_1 c_{\varphi_1} + r_2\omega_2 c_{\varphi_2} = r_3\omega_3 s_{\varphi_3}$""", "+ 2r_3", "- 2r_3"),
    "points of France": ("31", FIRST + """On note θ1 = φ1, θ2 = φ2, θ3 = φ3.
r1.θ1'.sin θ1 + r2.θ2'.sin θ2 + 2.r3.θ3'.sin θ3 = 0
r1.θ1'.cos θ1 + r2.θ2'.cos θ2 - r3.θ3'.sin θ3 = 0""", "- r3.θ3'", "+ r3.θ3'"),
    "Maple's prompt": ("31", FIRST + f"""> A := Matrix({MATRIX});
> b := Vector({RIGHT});
> w := LinearAlgebra:-LinearSolve(A, b);
> w1 := w[1]; w2 := w[2];""", "Vector([-2", "Vector([2"),
    "indices of Mathcad": ("31", """ω3(t,φ) := VMy(t)/(r3·(2·cos(φ[3) + sin(φ[3)))
ω4(t,φ) := 2·ω3(t,φ)·(cos(φ[3) − 2·sin(φ[3))
Δ(φ) := r1·r2·sin(φ[1 − φ[2)
ω1(t,φ) := −r3·ω3(t,φ)·sin(φ[3)·r2·(2·cos(φ[2) + sin(φ[2))/Δ(φ)
ω2(t,φ) := r3·ω3(t,φ)·sin(φ[3)·r1·(2·cos(φ[1) + sin(φ[1))/Δ(φ)""", "(cos(φ[3) − 2", "(cos(φ[3) + 2"),
    "lines between brackets": ("geared", """gl = [w4 + k*w1 == 0
      r1*w1*sin(phi1) + r2*w2*sin(phi2) - r3*w3*sin(phi3) - r4*w4*sin(phi4) == 0
      r1*w1*cos(phi1) + r2*w2*cos(phi2) - r3*w3*cos(phi3) - r4*w4*cos(phi4) == 0];
lsg = solve(gl, [w2 w3 w4]);""", "w4 + k", "w4 - k"),
    "a tuple": ("v107", """system = (
    Eq(u*cos(phi3) - s*w3*sin(phi3), VMx),
    Eq(u*sin(phi3) + s*w3*cos(phi3), VMy),
    Eq(b*w3*cos(phi3) + r2*w2*cos(phi2), VMy),
    Eq(b*w3*sin(phi3) + r2*w2*sin(phi2), -VMx - R*w1),
)
solution = linsolve(system, (u, w3, w2, w1))""", "-VMx - R", "-VMx + R"),
    "derivatives of own names": ("v107", """x_M = s*cos(phi3); y_M = s*sin(phi3)
eq1 = Eq(x_M.diff(t), VMx)
eq2 = Eq(y_M.diff(t), VMy)
eq3 = Eq(b*w3*cos(phi3) + r2*w2*cos(phi2), VMy)
eq4 = Eq(b*w3*sin(phi3) + r2*w2*sin(phi2), -VMx - R*w1)""", "x_M = s*cos", "x_M = s*sin"),
    "derivatives of equations": ("offset", """D[s[t] == a Cos[alpha[t]] + b Cos[beta[t]], t]
D[a Sin[alpha[t]] == -b Sin[beta[t]], t]""", "== -b", "== b"),
    "vectors of Typst": ("offset", "$ a omega_a vec(-sin alpha, cos alpha) + b omega_b vec(-sin beta, cos beta) = vec(v, 0) $\n"
        '$omega_a = w_a, omega_b = w_b$', "vec(-sin beta", "vec(sin beta"),
    "matrices of Typst": ("31", FIRST + "$ mat(r_1 sin phi_1, r_2 sin phi_2; r_1 cos phi_1, r_2 cos phi_2) vec(omega_1, omega_2)"
        " = vec(-2 r_3 omega_3 sin phi_3, r_3 omega_3 sin phi_3) $", "vec(-2", "vec(2"),
    "lines of Word": ("31", "{█(V_My=r_3 ω_3 (2 cos⁡φ_3+sin⁡φ_3 )@ω_4=2ω_3 (cos⁡φ_3-2 sin⁡φ_3 )"
        "@r_1 ω_1 sin⁡φ_1+r_2 ω_2 sin⁡φ_2=-2r_3 ω_3 sin⁡φ_3@r_1 ω_1 cos⁡φ_1+r_2 ω_2 cos⁡φ_2=r_3 ω_3 sin⁡φ_3 )┤",
        "=-2r_3", "=2r_3"),
    "matrices of Word": ("31", FIRST + "[■(r_1 sin⁡φ_1&r_2 sin⁡φ_2@r_1 cos⁡φ_1&r_2 cos⁡φ_2)](■(ω_1@ω_2))"
        "=[■(-2r_3 ω_3 sin⁡φ_3@r_3 ω_3 sin⁡φ_3)]", "(-2r_3", "(2r_3"),
    "secants": ("31", FIRST + """w1 = -((r3 w3 Csc[phi1 - phi2] (2 Cos[phi2] + Sin[phi2]) Sin[phi3])/r1)
w2 = r3 w3 Csc[phi1 - phi2] (2 Cos[phi1] + Sin[phi1]) Sin[phi3]/r2""", "w2 = r3", "w2 = -r3"),
    "colons of Maxima": ("31", """D: r1*r2*sin(phi1-phi2)$
V: r3*w3*sin(phi3)$
w3: VMy/(r3*(2*cos(phi3)+sin(phi3)))$
w4: 2*w3*(cos(phi3)-2*sin(phi3))$
w1: -V*r2*(2*cos(phi2)+sin(phi2))/D$
w2: V*r1*(sin(phi1)+2*cos(phi1))/D$""", "w2: V", "w2: -V"),
    "residuals": ("31", FIRST + """F = Matrix([
    r1*w1*sin(phi1) + r2*w2*sin(phi2) + 2*r3*w3*sin(phi3),
    r1*w1*cos(phi1) + r2*w2*cos(phi2) - r3*w3*sin(phi3)])""", "+ 2*r3", "- 2*r3"),
    "a name of its own": ("offset", """def speeds(alpha, beta, wa):
    wb = -a*wa*cos(alpha)/(b*cos(beta))
    vel = -a*wa*sin(alpha) - b*wb*sin(beta)
    return wb, vel""", "vel = -a", "vel = -2*a"),
    "part of a list": ("31", SYSTEM + "x = A\\b;\ndphi = [x; w3];", "b = [-2", "b = [2"),
    "entries": ("31", SYSTEM + """D = A[0][0]*A[1][1] - A[0][1]*A[1][0]
w1 = (b[0]*A[1][1] - A[0][1]*b[1])/D
w2 = (A[0][0]*b[1] - b[0]*A[1][0])/D""", "(A[0][0]*b[1] -", "(A[0][0]*b[1] +"),
    "columns put in": ("31", SYSTEM + """A1 = A.copy(); A1[:, 0] = b
A2 = A.copy(); A2[:, 1] = b
w1 = np.linalg.det(A1)/np.linalg.det(A)
w2 = np.linalg.det(A2)/np.linalg.det(A)""", "w2 = ", "w2 = -"),
    "columns side by side": ("31", FIRST + """A = [r1*sin(phi1) r2*sin(phi2); r1*cos(phi1) r2*cos(phi2)];
b = [-2*r3*w3*sin(phi3); r3*w3*sin(phi3)];
w1 = det([b A(:,2)])/det(A);
w2 = det([A(:,1) b])/det(A);""", "w2 = ", "w2 = -"),
    "handles": ("v105", """vx = @(t) V1*sin(p*t + alpha);  vy = @(t) V2*cos(p*t + alpha);
w12 = @(t,q) [r1*sin(q(1)) r2*sin(q(2)); r1*cos(q(1)) r2*cos(q(2))] \\ [-vx(t); vy(t)];
w34 = @(t,q) [r3*sin(q(3)) r4*sin(q(4)); r3*cos(q(3)) r4*cos(q(4))] \\ [-vx(t); vy(t)];""",
        "[-vx(t); vy(t)];\nw", "[vx(t); vy(t)];\nw"),
    "a right side of two systems": ("v105", """B = [-VMx; VMy];
A = [r1*sin(phi1), r2*sin(phi2); r1*cos(phi1), r2*cos(phi2)];
X = A\\B;  w1 = X(1);  w2 = X(2);
C = [r3*sin(phi3), r4*sin(phi4); r3*cos(phi3), r4*cos(phi4)];
Y = C\\B;  w3 = Y(1);  w4 = Y(2);""", "r4*cos(phi4)]", "-r4*cos(phi4)]"),
    "sines of an angle at once": ("31", """s = sin(phi);  c = cos(phi);
w3 = VMy/(r3*(2*c(3) + s(3)));
w4 = 2*w3*(c(3) - 2*s(3));
w1 = -w3*r3*s(3)*(2*c(2) + s(2))/(r1*(s(1)*c(2) - c(1)*s(2)));
w2 = w3*r3*s(3)*(2*c(1) + s(1))/(r2*(s(1)*c(2) - c(1)*s(2)));""", "w2 = w3", "w2 = -w3"),
    "columns in words": ("v102", """Spalte E (w3)  =-$B$6*SIN($B$7*A12+$B$8)/($B$4*SIN(D12)+$B$5*COS(D12))
Spalte F (u)   =E12*($B$5*SIN(D12)-$B$4*COS(D12))
Spalte G (w1)  =E12*($B$5*COS(D12)*COS(C12)+$B$4*COS(D12)*SIN(C12))/($B$2*SIN(B12-C12))
Spalte H (w2)  =-($B$4*E12*COS(D12)+$B$2*G12*COS(B12))/($B$3*COS(C12))
mit B2 = r1, B3 = r2, B4 = a, B5 = c, B6 = V1, B7 = p, B8 = alpha; A = t, B = phi1, C = phi2 und D = phi3""",
        "=E12*($B$5*SIN", "=E12*($B$5*COS"),
    "casts": ("geared", """double w4 = -(double) k * w1;
r2*w2*sin(phi2) - r3*w3*sin(phi3) = r4*w4*sin(phi4) - r1*w1*sin(phi1)
r2*w2*cos(phi2) - r3*w3*cos(phi3) = r4*w4*cos(phi4) - r1*w1*cos(phi1)""", "-(double)", "(double)"),
    "Δ'": ("31", FIRST + """Δ = r1 r2 sin(φ1-φ2)
Δ' = -r3 w3 r2 sinφ3 (2cosφ2 + sinφ2)
Δ'' = r3 w3 r1 sinφ3 (2cosφ1 + sinφ1)
w1 = Δ'/Δ
w2 = Δ''/Δ""", "w2 = Δ", "w2 = -Δ"),
    "rules over two lines": ("31", """Out[6]= {{w3 -> VMy/(r3 (2 Cos[phi3] + Sin[phi3])), w4 -> 2 w3 (Cos[phi3] - 2 Sin[phi3]),
 w1 -> -(r3 w3 Csc[phi1 - phi2] (2 Cos[phi2] + Sin[phi2]) Sin[phi3])/r1,
 w2 -> (r3 w3 Csc[phi1 - phi2] (2 Cos[phi1] + Sin[phi1]) Sin[phi3])/r2}}""", "w2 -> (", "w2 -> -("),
    "sines by pairs": ("31", FIRST + """c12, s12 = cos(phi1 - phi2), sin(phi1 - phi2)
w1 = -r3*w3*sin(phi3)*(2*cos(phi2) + sin(phi2))/(r1*s12)
w2 = r3*w3*sin(phi3)*(2*cos(phi1) + sin(phi1))/(r2*s12)""", "w2 = r3", "w2 = -r3"),
    "steps": ("31", FIRST + """Schritt 3) A = -2 r_3 omega_3 sin phi_3 ; B = r_3 omega_3 sin phi_3
Schritt 4) omega_1 = (A cos phi_2 - B sin phi_2) / [ r_1 sin(phi_1 - phi_2) ]
Schritt 5) omega_2 = (B sin phi_1 - A cos phi_1) / [ r_2 sin(phi_1 - phi_2) ]""", "(B sin phi_1 -", "(B sin phi_1 +"),
    "words of China": ("31", FIRST + """设 A＝sin(φ1－φ2)，则
ω1＝－r3·ω3·sinφ3·(2cosφ2＋sinφ2)/(r1·A)
ω2＝r3·ω3·sinφ3·(2cosφ1＋sinφ1)/(r2·A)""", "ω2＝r3", "ω2＝－r3"),
    "words behind a name": ("offset", """Geschwindigkeit des Zapfens v_K = a*wa längs und quer zur Stange:
v_K*cos(alpha) + b*wb*cos(beta) = 0
v = -v_K*sin(alpha) - b*wb*sin(beta)""", "v = -v_K", "v = -2*v_K"),
    "an aside": ("offset", """wb = -k*cos(alpha)/(b*cos(beta))   (k = a*wa, Umfangsgeschwindigkeit)
v = -a*wa*sin(alpha) - b*wb*sin(beta)""", "wb = -k", "wb = k"),
    "values in an own order": ("v102", """const w3 = -VMx/(a*Math.sin(phi3) + c*Math.cos(phi3));
const u = w3*(c*Math.sin(phi3) - a*Math.cos(phi3));
const d = r1*r2*Math.sin(phi1 - phi2);
const w1 = w3*r2*(c*Math.cos(phi3)*Math.cos(phi2) + a*Math.cos(phi3)*Math.sin(phi2))/d;
const w2 = -(a*w3*Math.cos(phi3) + r1*w1*Math.cos(phi1))/(r2*Math.cos(phi2));
return { w3, w2, u };""", "const u = w3", "const u = 2*w3"),
}  # fmt: skip


@pytest.mark.parametrize("form", FORMS)
def test_a_right_form_is_right_and_one_with_a_slip_is_not(form: str) -> None:
    name, text, piece, slip = FORMS[form]
    found = marked(text, name)
    assert (found.share, len(found.wrong)) == (1.0, 0), [(mark.verdict, mark.line.text) for mark in found.marks]
    assert piece in text and marked(text.replace(piece, slip, 1), name).share < 1.0


@pytest.mark.parametrize(("said", "independent"), [
    ("F = [-2*r3*w3*sin(phi3) + r1, r3*w3*sin(phi3) - r2*w4]", 2),  # no residuals of this task
    ("A*x = F\nF = [-2*r3*w3*sin(phi3) + r1*w2, r3*w3*sin(phi3) - r2*w4]", 2),
    ("r1*w1*sin(phi1) + r2*w2*sin(phi2) = -2*r3*w3*sin(phi3) = 0 ≠ 0", 2),
    ("x = A\\b;\ndphi = [w3; x];\nA = [r1*sin(phi1), r2*sin(phi2); r1*cos(phi1), r2*cos(phi2)];\nb = " + RIGHT, 2),
    (LAST.strip() + " mit negativem Vorzeichen rechts", 3),
    (f"A = {MATRIX}\nb = {RIGHT}\nw21 = np.linalg.solve(A, b)", 2),
    (f"""A = {MATRIX}\nb = {RIGHT}
Ai = A.copy(); Ai[:, 0] = b
w1 = det(Ai)/det(A)
Ai = A.copy(); Ai[:, 1] = b
w2 = det(Ai)/det(A)""", 2),  # which Ai is meant depends on the place
])  # fmt: skip
def test_what_is_no_right_equation_adds_none_and_is_asked_about(said: str, independent: int) -> None:
    found = marked(FIRST + said)
    assert (found.independent, len(found.wrong), found.unread is not None) == (independent, 0, True)
    assert marked(f"{FIRST}{LAST}{said}").share == 1.0


def test_a_running_index_of_what_no_equation_names_takes_nothing() -> None:
    assert marked(f"v_i = r_i*w_i\n{FIRST}{LAST}").share == 1.0
