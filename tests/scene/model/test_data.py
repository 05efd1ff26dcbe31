"""Columns of data: what is understood, and the one sentence about what is not."""

import numpy as np
import pandas as pd
import pytest

import coursework
from coursework.scene.model.one_set import with_numbers

MODEL = coursework.compile_model("31")


def test_a_frame_and_a_mapping_say_the_same():
    columns = {"p": [10.0, 12.0, 13.0], "phi1": [1.6, 1.63, 1.7]}
    for data in (MODEL.data(columns), MODEL.data(pd.DataFrame(columns))):
        assert data.count == 3
        assert data.given["p"].tolist() == columns["p"]
        assert data.given["r1"].tolist() == [0.953] * 3
        assert data.start[:, 0].tolist() == columns["phi1"] and data.start[:, 1].tolist() == [3.37] * 3


def test_numbers_are_si_and_texts_bring_their_unit():
    data = MODEL.data({"r1": ["953 mm", "0.95", 0.9], "alpha": "249.2 deg", "φ1": ["1.6 rad", "90°", "1.7"]})
    assert data.given["r1"].tolist() == [0.953, 0.95, 0.9]
    assert data.given["alpha"] == pytest.approx([np.radians(249.2)] * 3)
    assert data.start[:, 0] == pytest.approx([1.6, np.pi / 2, 1.7])


@pytest.mark.parametrize(
    ("columns", "sentence"),
    [
        ({"alfa": [1.0]}, 'data for 31: "alfa" is no given datum and no coordinate. Did you mean "alpha"?'),
        ({"V2": [1.0]}, 'data for 31: "V2" is no given datum and no coordinate. Known: r1, r2, r3, V1, p, alpha, phi1'),
        ([1, 2], "data for 31: a table of columns was expected, a mapping of names or a pandas frame, found list."),
        ({"w1": 3.0}, 'data for 31: "w1" is no given datum and no coordinate.'),
        ({"φ1": [1.6], "phi1": [1.6]}, 'data for 31: "phi1" stands twice among the columns.'),
        ({"r1": [1.0, 2.0], "p": [1.0]}, "the columns must have the same number of rows, found r1 2, p 1."),
        ({"r1": [1.0, np.nan]}, "r1, set 2: a finite number of at most 1e12 was expected, found nan."),
        ({"r1": [1.0, 2e12]}, "r1, set 2: a finite number of at most 1e12 was expected, found 2e+12."),
        ({"r1": [-2e12, 1.0]}, "r1, set 1: a finite number of at most 1e12 was expected, found -2e+12."),
        ({"r1": ["0.9 m", "1.1 s"]}, 'r1, set 2: a length was expected: m, cm, mm (found "1.1 s").'),
        ({"V1": "4.5 m"}, 'V1, set 1: a speed was expected: m/s, cm/s, mm/s (found "4.5 m").'),
        ({"phi1": ["1.6 m"]}, 'phi1, set 1: an angle was expected: rad, deg (found "1.6 m").'),
        ({"r1": [1.0, None]}, "r1, set 2: a number was expected, found None."),
        ({"r1": [True]}, "r1, set 1: a number was expected, found True."),
        ({"r1": [[1.0, 2.0]]}, "r1: one number per set was expected, found an array of shape (1, 2)."),
        ({"r1": [1.0, [2.0]]}, "r1: one number per set was expected"),
    ],
)  # fmt: skip
def test_what_is_wrong_is_said_in_one_sentence(columns, sentence):
    with pytest.raises(coursework.InputError) as caught:
        MODEL.data(columns)
    assert sentence in str(caught.value)
    assert str(caught.value).startswith(f"{caught.value.faults[0].code} data for 31: ")
    assert "\n" not in str(caught.value)


def test_the_largest_number_is_still_one():
    assert MODEL.data({"r1": 1e12}).given["r1"].tolist() == [1e12]


def test_no_sets_are_no_fault():
    assert MODEL.data({"p": []}).count == 0


def test_a_set_alone_has_its_own_numbers_and_starts():
    data = MODEL.data({"r1": [0.9, 0.95], "phi1": [1.7, 1.8]})
    data.start[:, 2] = np.nan  # as where a file leaves it open
    alone = with_numbers(MODEL.variant, data, 1)
    assert alone.values == MODEL.variant.values | {"r1": 0.95}
    assert [one.start for one in alone.coordinates] == [1.8, 3.37, None]
