"""The drawn geometry against what is known in closed form."""

from __future__ import annotations

import numpy as np
import pytest

from softcat_sym.plotting.section import (
    Section,
    elastic_core,
    node_angles,
    outline,
    quads_outside,
    section_at,
    slowest_flow,
    yielding_of,
)


def yielded_quads(section: Section, mean: np.ndarray, bending: np.ndarray, limit: float) -> np.ndarray:
    return quads_outside(section, *elastic_core(mean, bending, limit))


def area(polygon: np.ndarray) -> float:
    """Signed area by the shoelace formula, positive anticlockwise."""
    x, y = polygon[:, 0], polygon[:, 1]
    return 0.5 * float(np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y))


def arc(radius: float, half_angle: float, thickness: float, nodes: int = 401) -> Section:
    """A circular arc that opens upwards: its normal points to the centre."""
    angle = np.linspace(-half_angle, half_angle, nodes)
    normal = np.column_stack([-np.sin(angle), np.cos(angle)])
    return Section(radius * np.sin(angle), -radius * np.cos(angle), normal, np.full(nodes, thickness))


def test_outline_encloses_the_thickness_integrated_along_the_arc(descent):
    for frame in (0, 40, 200):
        x, y = descent["x"].values[frame], descent["y"].values[frame]
        expected = float(np.sum(descent["thickness"].values[frame] * np.hypot(np.diff(x), np.diff(y))))
        assert area(outline(section_at(descent, frame))) == pytest.approx(expected, rel=2e-4)


def test_outline_is_half_a_thickness_from_the_centreline_everywhere(descent):
    section = section_at(descent, 200)
    count = section.x.size
    closed = outline(section)
    below, above = closed[:count], closed[count:][::-1]
    centre = np.column_stack([section.x, section.y])
    np.testing.assert_allclose(np.linalg.norm(above - centre, axis=1), section.thickness / 2, rtol=1e-12)
    np.testing.assert_allclose(above + below, 2 * centre, atol=1e-15)
    assert np.all(above[:, 1] > below[:, 1]), "zeta = +1 is the side of (-sin th, cos th): above"


def test_node_angles_are_second_order_on_a_smooth_curve():
    errors = []
    for nodes in (41, 81):
        x = np.linspace(-1, 1, nodes)
        errors.append(np.abs(node_angles(x, np.cosh(x)) - np.arctan(np.sinh(x))).max())
    assert errors[1] < errors[0] / 3.5
    assert errors[1] < 1e-3


def test_node_angles_follow_a_curve_that_turns_past_the_vertical():
    angle = np.linspace(0, 1.9 * np.pi, 200)
    found = node_angles(np.sin(angle), -np.cos(angle))
    np.testing.assert_allclose(found, angle, atol=1e-3)


def test_a_kink_at_the_clamp_does_not_turn_the_end_face_around():
    x, y = np.array([0.0, 1e-3, 1.0, 2.0]), np.array([0.0, -5.0, -5.0, -5.0])
    assert abs(node_angles(x, y)[0] + np.pi / 2) < 0.31
    assert np.all(np.isfinite(node_angles(x[:2], y[:2])))


@pytest.mark.parametrize(
    ("mean", "bending", "core"),
    [
        (0.0, 0.0, (-1.0, 1.0)),
        (0.9, 0.0, (-1.0, 1.0)),
        (0.0, 2.0, (-0.5, 0.5)),
        (0.0, -2.0, (-0.5, 0.5)),
        (0.5, 2.0, (-0.75, 0.25)),
        (0.5, -2.0, (-0.25, 0.75)),
        (-0.5, 2.0, (-0.25, 0.75)),
        (0.5, 1.0, (-1.0, 0.5)),
        (0.5, -1.0, (-0.5, 1.0)),
        (0.5, 1e-320, (-1.0, 1.0)),
    ],
)
def test_elastic_core(mean, bending, core):
    lower, upper = elastic_core(np.array([9e3 * mean]), np.array([9e3 * bending]), 9e3)
    assert (lower[0], upper[0]) == pytest.approx(core, abs=1e-12)


@pytest.mark.parametrize("mean", [3.0, -3.0])
@pytest.mark.parametrize("bending", [0.0, 1.0, -1.0, 1e-320])
def test_a_cell_beyond_yield_everywhere_is_shaded_whole_and_once(mean, bending):
    section = arc(1.0, 0.5, 0.1, nodes=3)
    quads = yielded_quads(section, np.full(2, mean), np.full(2, bending), 1.0)
    assert sum(area(quad) for quad in quads) == pytest.approx(area(outline(section)), rel=1e-12)


def test_every_shaded_point_exceeds_yield_and_no_other_does():
    generator = np.random.default_rng(7)
    mean, bending = generator.normal(size=400), 3 * generator.normal(size=400)
    lower, upper = elastic_core(mean, bending, 1.0)
    zeta = np.linspace(-0.999, 0.999, 301)[:, None]
    shaded = (zeta < lower) | (zeta > upper)
    # A point within rounding of the boundary may fall on either side.
    clear = np.abs(np.abs(mean + bending * zeta) - 1.0) > 1e-9
    np.testing.assert_array_equal(shaded[clear], (np.abs(mean + bending * zeta) > 1.0)[clear])


def test_shaded_share_of_a_straight_filament_is_the_analytic_yielded_fraction(make_scene, make_run):
    """Stress Y(0.5 + 2 c zeta): the area fraction integrates (1 - core/2) over X."""
    scene, cells = make_scene(limit=1.0), 4000
    data = make_run(scene, np.zeros(1), np.zeros(1), cells)
    X = data["X_cell"].values
    slope = 4.0 * X / scene.filament.span
    section = section_at(data, 0)
    quads = yielded_quads(section, np.full(cells, 0.5), slope, 1.0)
    share = sum(area(quad) for quad in quads) / area(outline(section))
    # Tension beyond zeta = 0.5/|slope| where |slope| > 0.5; compression beyond 1.5/|slope| where |slope| > 1.5.
    # With u = |slope| uniform on (0, 2): fraction = 1/2 E[(1 - 0.5/u)+] + 1/2 E[(1 - 1.5/u)+].
    tension = (1.5 - 0.5 * np.log(2 / 0.5)) / 2
    compression = (0.5 - 1.5 * np.log(2 / 1.5)) / 2
    assert share == pytest.approx(0.5 * (tension + compression), rel=1e-4)


@pytest.mark.parametrize(("side", "bending"), [(1, 1.0), (-1, -1.0)])
def test_shaded_band_of_an_arc_has_the_area_of_a_ring_sector(side, bending):
    """Stress 0.8 + zeta (or its mirror) exceeds 1 beyond zeta = 0.2, on the side of the stress's growth."""
    radius, half_angle, thickness = 1.0, 0.6, 0.2
    section = arc(radius, half_angle, thickness)
    cells = section.x.size - 1
    quads = yielded_quads(section, np.full(cells, 0.8), np.full(cells, bending), 1.0)
    inner, outer = sorted(radius - side * thickness / 2 * zeta for zeta in (0.2, 1.0))
    assert sum(area(quad) for quad in quads) == pytest.approx(half_angle * (outer**2 - inner**2), rel=1e-5)


@pytest.mark.parametrize("limit", [None, 1e9])
def test_nothing_is_shaded_without_a_yield_stress_or_below_it(descent, make_scene, limit):
    found = yielding_of(descent.assign(yielded_fraction=0 * descent.yielded_fraction), make_scene(limit=limit))
    assert quads_outside(section_at(descent, 200), found.low[200], found.high[200]).shape == (0, 4, 2)
    assert not found.share.any()


def test_yielded_is_what_flows_and_not_what_rests_on_the_yield_stress(descent, scene):
    """Flow of a unit of strain in the first half; then specks of single frames, as a solver's tolerance makes them."""
    time, cells = descent.time.values, descent.sizes["cell"]
    frame, cell = np.meshgrid(np.arange(time.size), np.arange(cells), indexing="ij")
    moving = frame < 101
    specks = (frame > 120) & ((7 * frame + 13 * cell) % 29 == 0)
    rate = np.where(moving, 1.0, np.where(specks, 3e-3, 0.0))
    fraction = np.where(moving, 0.4, np.where(specks, 0.9, 0.0))
    run = descent.assign(
        plastic_rate=(("time", "cell"), rate),
        yielded_fraction=(("time", "cell"), fraction),
        stress_mean=(("time", "cell"), np.where(fraction > 0, 1.001, 0.999) * scene.material.yield_stress),
        stress_bending=(("time", "cell"), 0 * rate),
    )
    # A thousandth, the accuracy asked, of the strain of the run, in its two seconds.
    assert slowest_flow(run, scene) == pytest.approx(1e-3 * 1.0 / 2.0, rel=0.01)
    found = yielding_of(run, scene)
    np.testing.assert_array_equal(found.share, np.where(moving, 0.4, 0.0))
    np.testing.assert_array_equal(found.high - found.low, np.where(moving, 0.0, 2.0))
    slow = run.assign(plastic_rate=(("time", "cell"), np.where(moving, 1.0, 1e-3)))
    np.testing.assert_array_equal(yielding_of(slow, scene).share, fraction)


def test_shaded_share_follows_the_yielded_fraction_of_the_run(descent, scene):
    for frame in (40, 90, 200):
        section = section_at(descent, frame)
        mean, bending = descent["stress_mean"].values[frame], descent["stress_bending"].values[frame]
        quads = yielded_quads(section, mean, bending, scene.material.yield_stress)
        arc_length = np.hypot(np.diff(section.x), np.diff(section.y))
        weight = arc_length * descent["thickness"].values[frame]
        expected = float(np.sum(weight * descent["yielded_fraction"].values[frame]) / weight.sum())
        # A bent filament is longer on its outer side, by thickness times curvature: a few per cent here.
        assert sum(area(quad) for quad in quads) / area(outline(section)) == pytest.approx(expected, rel=0.06)


def test_the_section_in_a_clamp_stays_vertical(descent):
    free, held = section_at(descent, 200), section_at(descent, 200, (True, False))
    np.testing.assert_allclose(held.normal[0], [0.0, 1.0], atol=1e-15)
    np.testing.assert_array_equal(held.normal[1:], free.normal[1:])
    assert abs(free.normal[0][0]) > 0.01
