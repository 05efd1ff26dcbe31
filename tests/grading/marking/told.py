"""The causes that explain a marked table, of all that are told of it."""

from coursework.grading.marking.table.causes.claims import TableUnderTest
from coursework.grading.marking.table.causes.hypotheses import claims
from coursework.grading.marking.table.causes.misconceptions import explanations


def found_in(key, cells, confusions=None, others=None, hidden=(), equations=None):
    told = claims(TableUnderTest(key, cells.student), confusions or {}, others or {}, equations)
    return explanations(key, cells, told, hidden, equations)
