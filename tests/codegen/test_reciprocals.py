"""Divisions that are shared become products, without another value."""

from __future__ import annotations

import casadi as ca
import numpy as np

from softcat_sym.codegen.recording import PARAMETER, PER, PLACE, UNKNOWN, Code, Leaf, code_of, with_reciprocals

from .snippets import text_of, values

NAMES = ("y", "z", "p", "h")
Y, Z, P, H = (ca.SX.sym(name) for name in NAMES)
LEAVES = [Leaf(UNKNOWN, "y"), Leaf(UNKNOWN, "z", 1), Leaf(PARAMETER, "p"), Leaf(PLACE, "cell")]
MIXED = [Y / Z + P / Z, 1 / Z, (Y + Z) / P, Y / 7, (Y - Z) / H, 1 / H, Y / (Z + P), Z / (P * P), P / (P + 1)]


def divisions(code: Code) -> int:
    return sum(one.operation in ("DIV", "INV") for one in code.instructions)


def of(expressions: list[ca.SX]) -> tuple[Code, Code, list[Leaf]]:
    plain = code_of([Y, Z, P, H], expressions)
    return plain, *with_reciprocals(plain, LEAVES)


def test_values_are_the_same() -> None:
    plain, code, leaves = of(MIXED)
    x = np.random.default_rng(1).uniform(0.4, 3, (200, 4)) * np.array([1, -1, 1, 1])
    x[:, 2] = x[0, 2]
    assert leaves == [*LEAVES, Leaf(PLACE, PER + "cell")]
    more = np.concatenate([x, 1 / x[:, 3:]], axis=1)
    wanted, found = (values(text_of(c, r.shape[1]), r, len(MIXED)) for c, r in ((plain, x), (code, more)))
    # Three roundings in place of one, against the larger of what is added.
    np.testing.assert_allclose(found, wanted, rtol=1e-15, atol=1e-15)
    assert divisions(code) <= divisions(plain) / 2


def test_how_many_divisions_are_left() -> None:
    for expressions, left in [
        ([Y / Z], 1),  # a single quotient is no dearer than an inverse and a product
        ([Y / Z, P / Z, H / Z], 1),  # one inverse for three quotients
        ([Y / P], 1),  # one inverse for all sites
        ([P / (P + 1)], 1),  # computed once for all sites anyway
        ([Y / 3], 0),  # the inverse of a number is a number
        ([Y / H, 1 / H], 0),  # the inverse of a length is given
    ]:
        _, code, _ = of(expressions)
        assert divisions(code) == left


def test_an_inverse_of_what_all_sites_share_is_computed_before_the_loop() -> None:
    _, code, leaves = of([Y / P, Z / P])
    text = text_of(code, 4, [not leaf.is_local for leaf in leaves])
    head, loop = text[text.index("void f") :].split("for (int i")
    assert "1.0 /" in head
    assert "/" not in loop


def test_a_division_by_zero_stays_what_it_is() -> None:
    plain, code, _ = of([Y / Z, H / Z])
    x = np.array([[1.0, 0, 1, 0], [-1.0, 0, 1, 2], [0.0, 0, 1, 2]])
    assert divisions(code) < divisions(plain)
    found, wanted = (values(text_of(one, 4), x, 2) for one in (code, plain))
    np.testing.assert_array_equal(found, wanted)


def test_no_result_is_lost() -> None:
    plain, code, leaves = of([ca.SX(0), Y, H, Y / Z])
    assert len(code.results) == len(plain.results) == 4
    x = np.array([[1.0, 2.0, 3.0, 4.0]])
    assert len(leaves) == 4
    assert values(text_of(code, 4), x, 4).tolist() == [[0, 1, 4, 0.5]]
