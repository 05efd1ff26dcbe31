"""What a page's stylesheet keeps: every rule that may concern it, and no other."""

from __future__ import annotations

import pytest

from coursework.words.stylesheets import fitted

BODY = '<main lang="en" id="top"><p class="one two"><svg stroke="#111"></svg></main>'


@pytest.mark.parametrize(
    ("rules", "kept"),
    [
        ("p{a:b}.three{a:b}h1{a:b}#top{a:b}", "p{a:b}#top{a:b}"),
        (".one.three,.two p,main > .one{a:b}", ".two p,main > .one{a:b}"),
        (":is(.one,.three) p{a:b}:is(.three,h1) p{a:b}", ":is(.one,.three) p{a:b}"),
        ("p:not(.three):nth-child(2n + 1)::after{a:b}", "p:not(.three):nth-child(2n + 1)::after{a:b}"),
        ('svg [stroke="#111"]{a:b}svg [stroke="#222"]{a:b}', 'svg [stroke="#111"]{a:b}'),
        (":lang(zh) p{a:b}:lang(en) p{a:b}", ":lang(en) p{a:b}"),
        ("@media print{.three{a:b}}@media print{.two{a:b}}", "@media print{.two{a:b}}"),
        ("@page{size:A4;@bottom-center{content:counter(page)}}", "@page{size:A4;@bottom-center{content:counter(page)}}"),
        ("p{page:wide}@page wide{a:b}@page tall{a:b}", "p{page:wide}@page wide{a:b}"),
        ("p{a:b}p:has(.one){a:b;>b{a:b}}p:has(.three){a:b;>p{a:b}}p{a:b}", "p{a:b}p:has(.one){a:b;}p{a:b}"),
        (":root{--x:red;--y:var(--z);--z:blue;}p{color:var(--x)}", ":root{--x:red;--z:blue;}p{color:var(--x)}"),
    ],
)
def test_a_rule_is_kept_where_it_concerns_something(rules: str, kept: str) -> None:
    assert fitted(f"<style>{rules}</style>{BODY}") == f"<style>{kept}</style>{BODY}"


def test_a_script_may_make_any_element_and_give_it_the_classes_that_it_names() -> None:
    body = '<p><script>add("table", "made")</script>'
    assert fitted(f"<style>.made table{{a:b}}.never,ul{{a:b}}</style>{body}") == f"<style>.made table{{a:b}}</style>{body}"


def test_a_page_without_a_stylesheet_stays() -> None:
    assert fitted(BODY) == BODY
