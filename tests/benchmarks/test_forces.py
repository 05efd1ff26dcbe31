"""What forces cost beside what they are computed from: ratios of processor time, never seconds."""

import numpy as np

import coursework
from coursework.effects.dynamics.dynamics import Dynamics
from coursework.effects.kinetostatics.analysis import analyse
from coursework.motion.integration.integrate import March
from coursework.motion.schemes import SCHEMES
from tests.benchmarks.timer import ratio
from tests.effects.massed import massed
from tests.effects.moved import free_31

STEPS = 10_000
MOST, MOST_EXACT = 12, 5  # 7.6 and 2.9 measured


def test_steps_of_dynamics_beside_steps_of_the_kinematic_march():
    text = free_31('rates = ["w1", "w2"]\nstart = { w1 = "0.2 rad/s", w2 = "0.1 rad/s" }\n')
    run = coursework.solve(coursework.parse_variant(text), scheme="euler", step=0.48e-6 * 10, end=0.48e-5 * 10)
    places, state = run.scene.begin_of_forces
    driven = coursework.solve("31", quantities=["table"]).scene
    made = Dynamics(run.scene.free_equations, places).rows(SCHEMES["euler"], state, 1e-6, STEPS)
    assert (len(made.t), made.ended) == (STEPS + 1, "")
    found = ratio(
        lambda: Dynamics(run.scene.free_equations, list(places)).rows(SCHEMES["euler"], state, 1e-6, STEPS),
        lambda: March(driven.rates, SCHEMES["euler"], 0.48 / STEPS).until(driven.start, 0.48), most=MOST,
    )  # fmt: skip
    assert found <= MOST


def test_forces_of_a_mechanism_of_seven_links_beside_its_exact_rows():
    scene = coursework.solve(massed(coursework.load("jansen")), scheme="exact").scene
    second = scene.exact_accelerations
    found = ratio(
        lambda: analyse(scene.mechanism, scene.equations, scene.exact, second, scene.exact),
        lambda: scene.exact_at(np.array(scene.exact.t)), most=MOST_EXACT,
    )  # fmt: skip
    assert found <= MOST_EXACT
