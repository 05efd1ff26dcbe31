"""Which tabulated laws a program calls: by name and order, no others."""

from types import SimpleNamespace

from coursework.equations.codegen.javascript import called_tables


def test_the_tables_that_a_line_reads_are_called_and_no_others():
    lines = [SimpleNamespace(text="w1 = _table_f_1(t) + sin(_table_g_0(q1))"), SimpleNamespace(text="x = 2*_table_f_10(t)")]
    found = called_tables(SimpleNamespace(lines=lines, tables={"f": None, "g": None, "h": None}))
    assert found == {"_table_f_1": ("f", 1), "_table_g_0": ("g", 0)}
