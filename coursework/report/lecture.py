"""The formula of each scheme as it stands in the lecture.

Enters: the name of a scheme.  Leaves: (Typst math, plain text) of each line.  A scheme without lines is named only.
"""

from __future__ import annotations

LINES: dict[str, tuple[tuple[str, str], ...]] = {
    "euler": (("q_(i+1) = q_i + h f(t_i, q_i)", "q_{i+1} = q_i + h f(t_i, q_i)"),),
    "midpoint": (
        (
            "q_(i+1) = q_i + h f(t_i + h/2, q_i + h/2 f(t_i, q_i))",
            "q_{i+1} = q_i + h f(t_i + h/2, q_i + h/2 f(t_i, q_i))",
        ),
    ),
    "heun": (
        ("k_1 = f(t_i, q_i), quad k_2 = f(t_i + h, q_i + h k_1)", "k₁ = f(t_i, q_i), k₂ = f(t_i + h, q_i + h k₁)"),
        ("q_(i+1) = q_i + h/2 (k_1 + k_2)", "q_{i+1} = q_i + h/2 (k₁ + k₂)"),
    ),
    "rk4": (
        (
            "k_1 = f(t_i, q_i), quad k_2 = f(t_i + h/2, q_i + h/2 k_1)",
            "k₁ = f(t_i, q_i), k₂ = f(t_i + h/2, q_i + h/2 k₁)",
        ),
        (
            "k_3 = f(t_i + h/2, q_i + h/2 k_2), quad k_4 = f(t_i + h, q_i + h k_3)",
            "k₃ = f(t_i + h/2, q_i + h/2 k₂), k₄ = f(t_i + h, q_i + h k₃)",
        ),
        ("q_(i+1) = q_i + h/6 (k_1 + 2 k_2 + 2 k_3 + k_4)", "q_{i+1} = q_i + h/6 (k₁ + 2 k₂ + 2 k₃ + k₄)"),
    ),
}
