"""Robust losses by winsorised readings: optima are those of SciPy, and intervals contain the truth in 95 of 100."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import least_squares

from softcat_sym.errors import SoftcatError
from softcat_sym.fitting.identifiability import information
from softcat_sym.fitting.inference import profile
from softcat_sym.fitting.least_squares import Optimum, minimise
from softcat_sym.fitting.likelihood import Errors, Loss, Noise, Residuals, estimate_noise
from tests.common.draws import draws, errors_away, shares
from tests.common.fit_problems import Problem, decay, problem, saturation

TRUTH = np.array([0.5, 0.2])
LOSSES = [Loss("soft-l1", 1.0), Loss("cauchy", 1.0), Loss("cauchy", 2.4)]


def film(seed: int, wild: float) -> Problem:
    """Sixty points; some are 5 to 30 standard deviations off, to either side."""
    p = problem("v K", saturation, TRUTH.tolist(), 0.03, seed)
    random = draws(9000 + seed)
    off = (random.random(p.data.size) < wild) * random.choice([-1, 1], p.data.size)
    p.data = p.data + off * p.std * random.uniform(5, 30, p.data.size)
    return p


def winsorised(p: Problem, loss: Loss, *, stated: bool) -> tuple[Problem, Optimum, Noise]:
    """The problem with outliers moved towards the model and with their noise, its optimum, and the noise."""
    count = p.data.size
    unit, free = np.full(count, p.std if stated else 1.0), np.zeros(count, dtype=bool)
    errors = Errors(unit, free, np.arange(1.0 * count), np.zeros((count, 0)), np.zeros((count, count)))
    noise, posed, q = Noise(1.0 if stated else p.std), p, TRUTH
    for _ in range(30):
        best = minimise(posed, q)
        values, slopes = p.model(best.q)
        of_film = [Residuals(errors, values - p.data, slopes)]
        least = (1e-12, 1e-12)
        found = estimate_noise(noise, of_film, np.zeros((0, q.size)), stated=(stated, stated), least=least, loss=loss)
        noise, former = found.noise, q
        std = float(noise.winsorised * errors.std(noise)[0])
        posed = Problem(p.names, p.lower, p.upper, p.model, values - found.residuals[0], std)
        q = best.q
        if np.abs(q - former).max() < 1e-9:
            break
    return posed, minimise(posed, q), noise


@pytest.mark.parametrize("loss", LOSSES, ids=str)
def test_the_optimum_is_that_of_scipy(loss: Loss) -> None:
    p = problem("A k", decay, TRUTH.tolist(), 0.01)
    p.data[::7] += 0.1
    _, found, _ = winsorised(p, loss, stated=True)
    other = least_squares(
        p.residuals,
        TRUTH,
        jac=lambda q: p.linearised(q)[1],
        loss=loss.kind.replace("-", "_"),
        f_scale=loss.scale,
        xtol=1e-14,
        ftol=1e-14,
        gtol=1e-14,
    )
    np.testing.assert_allclose(found.q, other.x, atol=1e-6)
    plain = minimise(p, TRUTH)
    assert np.abs(found.q - TRUTH).max() < 0.6 * np.abs(plain.q - TRUTH).max()


def test_psi_and_its_slope_are_derivatives_of_the_loss_and_others_are_refused() -> None:
    h = 1e-4
    for kind in ("linear", "soft-l1", "cauchy"):
        loss = Loss(kind, 1.7)  # type: ignore[arg-type]
        for r in (-1.5, -0.1, 0.3, 1.2, 4.0):
            low, middle, high = (loss.value(np.array([r + s])) for s in (-h, 0.0, h))
            assert (high - low) / (2 * h) == pytest.approx(float(loss.psi(np.array([r]))[0]), rel=1e-6)
            assert (high - 2 * middle + low) / h**2 == pytest.approx(float(loss.slopes(np.array([r]))[0]), rel=1e-4)
    with pytest.raises(SoftcatError, match="accepted: linear, soft-l1, cauchy"):
        Loss("huber")  # type: ignore[arg-type]
    with pytest.raises(SoftcatError, match="positive"):
        Loss("cauchy", 0.0)


def covered(loss: Loss, wild: float, sets: int, profiled: int, *, stated: bool) -> tuple[np.ndarray, np.ndarray]:
    """Shares of films whose interval holds the truth: by the curvature, by profiles."""
    curved, traced = np.zeros(2), np.zeros(2)
    for seed in range(sets):
        p, best, _ = winsorised(film(seed, wild), loss, stated=stated)
        box = p.lower, p.upper
        known = information(p.names, best.q, best.residuals, best.jacobian, box, noise_known=False)
        curved += np.abs(best.q - TRUTH) < known.quantile * known.standard_errors
        for k in range(2 if seed < profiled else 0):
            one = profile(p, best.q, k, noise_known=False)
            traced[k] += one.lower.crossing < TRUTH[k] < one.upper.crossing
    return curved / sets, traced / max(profiled, 1)


@pytest.mark.slow
@pytest.mark.statistical
@pytest.mark.parametrize(
    ("loss", "wild", "stated"), [(LOSSES[0], 0.05, False), (LOSSES[1], 0.1, False), (LOSSES[2], 0.0, True)], ids=str
)
def test_intervals_contain_the_truth(loss: Loss, wild: float, stated: bool) -> None:
    curved, traced = covered(loss, wild, 400, 40, stated=stated)
    print(f"{loss.kind} {loss.scale} wild {wild:.0%} stated {stated}: curvature {curved}, profiles {traced}")
    # Binomials, of a theory for many readings and of sixty.
    for found, sets in ((curved, 400), (traced, 40)):
        assert np.all((found >= shares(sets, 0.93)[0]) & (found <= shares(sets, 0.96)[1]))


@pytest.mark.statistical
@pytest.mark.parametrize("loss", LOSSES, ids=str)
@pytest.mark.parametrize("stated", [True, False])
def test_the_noise_of_winsorised_readings_is_that_of_the_asymptotic_theory(loss: Loss, stated: bool) -> None:
    """sqrt(E psi^2)/E psi' of normal residuals, by the trapezoidal rule."""
    z = np.linspace(-10, 10, 20001)
    density = np.exp(-0.5 * z**2) / np.sqrt(2 * np.pi)
    psi = loss.psi(z)
    theory = np.sqrt(np.trapezoid(psi**2 * density, z)) / np.trapezoid(np.gradient(psi, z) * density, z)
    size, sets, found = 500, 40, list[Noise]()
    for seed in range(sets):
        errors = Errors(
            np.ones(size),
            np.zeros(size, dtype=bool),
            np.arange(1.0 * size),
            np.zeros((size, 0)),
            np.zeros((size, size)),
        )
        of_film = [Residuals(errors, draws(3, seed).standard_normal(size), np.ones((size, 1)))]
        how = {"stated": (stated, stated), "least": (1e-9, 1e-9), "loss": loss}
        found.append(estimate_noise(Noise(1.0), of_film, np.zeros((0, 1)), **how).noise)  # type: ignore[arg-type]
    assert theory > 1.02
    # Of N readings both are off by up to 1.5/sqrt(N), as a deviation of 60 times 20 000 draws has it for each loss.
    far = 1.5 * errors_away() / np.sqrt(size * sets)
    mean = np.mean([one.deviation for one in found])
    assert np.mean([one.deviation * one.winsorised for one in found]) == pytest.approx(theory, rel=far + 0.002)
    assert mean == pytest.approx(1.0, rel=far + 0.002)
