"""``softcat fit``: fit of a material to films of falling filaments, with intervals."""

from __future__ import annotations

import shlex
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from softcat_sym.cli import application as cli
from softcat_sym.cli.completing import complete_scene
from softcat_sym.fitting import STARTS
from softcat_sym.lazy import lazy_imports
from softcat_sym.progress import StudyDisplay

if TYPE_CHECKING:
    from softcat_sym.fitting.result import Fit
    from softcat_sym.scene.scene import Scene
    from softcat_sym.tracking.result import Track

with lazy_imports():
    from softcat_sym.fitting import closed_form, collapse_test, measurements, model_selection
    from softcat_sym.fitting import fit as fitting
    from softcat_sym.fitting import posterior as bayes
    from softcat_sym.tracking import calibration
    from softcat_sym.tracking import film as filmed
    from softcat_sym.tracking import track as tracking

_FORM = "write a name, two values and a unit, such as viscosity=1:1e4 Pa*s"


def fit(
    data: Annotated[
        list[Path],
        typer.Argument(
            metavar="DATA...",
            help="CSV files, one for each filament, with columns time_s, midpoint_m and others; or films, with "
            "--film-scale.",
        ),
    ],
    scene: Annotated[
        str,
        cli.option(
            "SCENE",
            "Scene with the known values: the name of a bundled scene, or the path of a TOML file.",
            autocompletion=complete_scene,
        ),
    ],
    output: cli.OutputOption = None,
    free: Annotated[
        cli.Texts,
        cli.option("NAME", "Parameter to fit, such as viscosity. Repeatable."),
    ] = None,
    law: Annotated[
        cli.Texts,
        cli.option(
            "LAW",
            "Fit every constant of this law; two laws or more are compared. Repeatable; --free then adds to them.",
        ),
    ] = None,
    film_scale: Annotated[
        cli.Text,
        cli.option(
            "WHAT=LENGTH",
            "Scale of DATA that are films, which are tracked, their clock fitted: 'span=50 mm' (see track).",
        ),
    ] = None,
    test: Annotated[
        cli.Text,
        cli.option(
            "TEST",
            "collapse: DATA is the contour (x, y) of a strand on pillars; its yield stress and modulus are fitted.",
        ),
    ] = None,
    bounds: Annotated[
        cli.Texts, cli.option("NAME=LOW:HIGH", "Bounds of a parameter: 'viscosity=1:1e4 Pa*s'. Repeatable.")
    ] = None,
    starts: Annotated[
        int, cli.option(None, "Initial guesses besides the scene's values and the closed form's.", min=0)
    ] = STARTS,
    method: Annotated[
        str, cli.option("METHOD", "Search for the optimum: least-squares (SciPy), or ipopt, which takes longer.")
    ] = "least-squares",
    no_profiles: Annotated[
        bool,
        cli.switch(
            "Take intervals from the curvature at the optimum: faster, and less accurate.", "--no-profile-likelihood"
        ),
    ] = False,
    flow_curve: Annotated[
        Path | None, cli.option("CSV", "Flow curve of the same material, which is fitted together with the films.")
    ] = None,
    calibrated: Annotated[
        bool,
        cli.switch(
            "Assume exact scale, clock, zero and tilt of the camera; else 2 %, one frame, 2 % and 1 deg.",
            "--calibrated",
        ),
    ] = False,
    no_discrepancy: Annotated[
        bool, cli.switch("Leave the theory's own error out of the intervals.", "--no-discrepancy")
    ] = False,
    time_limit: Annotated[
        cli.Number,
        cli.option("SECONDS", "Time after which the fit ends with the best result so far.", callback=cli.checked_limit),
    ] = None,
    features_only: Annotated[
        bool,
        cli.switch("Read features and print E and eta by the closed form, without fitting.", "--features-only"),
    ] = False,
    posterior: Annotated[
        bool, cli.switch("Also draw from the posterior; this needs the extra bayes.", "--posterior")
    ] = False,
    prior: Annotated[
        cli.Texts,
        cli.option(
            "NAME=DIST",
            "Prior of a parameter, from scipy.stats: 'viscosity=lognorm(s=0.5, scale=30 Pa*s)'. Repeatable.",
        ),
    ] = None,
    seed: Annotated[int, cli.option(None, "Seed of the initial guesses.", min=0)] = 0,
    fresh: cli.FreshOption = False,
    changes: cli.SetOption = None,
    quiet: cli.QuietOption = False,
) -> None:
    """Fit a material to films of a falling filament.

    DIR gets fit.json, fit.html, scene.toml, pictures and a table.
    With several --law the best is written as the fit; laws.csv, laws.png, fit.json and fit.html rank them all. Exit
    status 0 if an optimum was found. A parameter that the data do not determine has a verdict instead of a value. After
    Ctrl-C the same command resumes from the finished evaluations, and gives the same numbers.
    """
    if features_only:
        given = {"--free": free, "--law": law, "--test": test, "--flow-curve": flow_curve, "--prior": prior}
        _check_features(data, given | {"--posterior": posterior})
    else:
        _check(data, free or [], law or [], test, flow_curve, prior or [], posterior=posterior)
    limits, before = _bounds(bounds or []), _priors(prior or [])
    known, output = cli.scene_and_directory(scene, changes, output, "fit")
    command = shlex.join(["softcat", *(word for word in sys.argv[1:] if word != "--fresh")])
    data, tracks = _tracked(data, film_scale, output, quiet=quiet)
    if tracks and not calibrated and not any(name.startswith("time_offset") for name in free or []):
        # A tracked release is known to half a frame: too much for an error of first order.
        free = [*(free or []), "time_offset"]
    if features_only:
        cli.present(closed_form.closed_form(data[0], known), output, quiet=quiet, command=command)
        return
    if posterior:
        # A missing package is reported before the fit.
        bayes.packages()
    films = collapse_test.read_contour(data[0]) if test else measurements.read_measurements(data)
    with cli.study(fresh=fresh), StudyDisplay(quiet=quiet) as progress:
        progress.doing("reading and compiling")
        how: fitting.FitOptions = {
            "bounds": limits,
            "starts": starts,
            "seed": seed,
            "method": method,  # type: ignore[typeddict-item]
            "progress": progress,
            "profiles": not no_profiles,
            "calibrated": calibrated,
            "discrepancy": not no_discrepancy,
            "time_limit": time_limit,
            "flow_curve": flow_curve,
            "priors": before,
        }
        found, compared, collapse = _fitted(films, known, free or [], law or [], how)
        drawn = bayes.posterior_of(found, seed=seed, progress=progress) if posterior else None
    beside = {"laws": compared, "posterior": drawn, "collapse": collapse, "tracks": tracks}
    cli.present(found, output, quiet=quiet, command=command, **beside)
    if not found.outcome.converged:
        if quiet:
            cli.print_error(f"{found.outcome.word}: {found.outcome.value}")
        raise typer.Exit(cli.UNTRUSTED)
    if drawn is not None and not drawn.outcome.is_success:
        raise typer.Exit(cli.UNTRUSTED)


def _tracked(data: list[Path], scale: str | None, output: Path, *, quiet: bool) -> tuple[list[Path], dict[int, Track]]:
    """Track the films among the data and write their tables into DIR; the tracks by their places in the data."""
    places = [place for place, path in enumerate(data) if filmed.is_film(path)]
    if bool(places) != (scale is not None):
        what = f"{data[places[0]]} is a film: name its scale" if places else "no film among DATA: leave it out"
        raise typer.BadParameter(f"{what}; accepted: {calibration.SCALES}", param_hint="--film-scale")
    tables, tracks = list(data), {}
    with StudyDisplay(quiet=quiet) as progress:
        for place in places:
            progress.stage(f"tracking {data[place].name}")
            tracks[place] = tracking.track(data[place], scale or "", progress=progress)
            name = data[place].stem if len(places) == 1 else f"{data[place].stem}-{place + 1}"
            tables[place] = tracks[place].save(output / f"{name}.csv")
    return tables, tracks


def _check_features(data: list[Path], given: dict[str, object]) -> None:
    """Refuse options of a fit, and a second film, beside --features-only."""
    for name in (name for name, value in given.items() if value):
        raise typer.BadParameter("--features-only reads features and fits nothing: leave one of both", param_hint=name)
    if len(data) > 1:
        raise typer.BadParameter("--features-only takes one film", param_hint="DATA")


def _check(
    data: list[Path],
    free: list[str],
    law: list[str],
    test: str | None,
    flow_curve: Path | None,
    prior: list[str],
    *,
    posterior: bool,
) -> None:
    """Refuse options that contradict each other."""
    faults = [
        ("--free", test is None and not free and not law, "name at least one parameter, or a law with --law"),
        ("--test", test not in (None, "collapse"), f"{test!r} is no test; accepted: collapse"),
        ("DATA", test is not None and len(data) > 1, "a collapse test has one contour"),
        ("--law", test is not None and bool(law), "a collapse test fits the law of the scene"),
        ("--flow-curve", test is not None and flow_curve is not None, "a collapse test fits the contour alone"),
        ("--prior", bool(prior) and not posterior, "priors belong to a posterior: add --posterior"),
    ]
    for name, is_wrong, message in faults:
        if is_wrong:
            raise typer.BadParameter(message, param_hint=name)


def _fitted(
    films: measurements.Measurements | collapse_test.Contour,
    known: Scene,
    also: list[str],
    law: list[str],
    how: fitting.FitOptions,
) -> tuple[Fit, model_selection.LawComparison | None, collapse_test.CollapseTest | None]:
    """The fit, or, of several laws, the best fit with the comparison; of a contour with what its gaps show."""
    if isinstance(films, collapse_test.Contour):
        collapse = collapse_test.collapse_test(films, known, also, **how)
        return collapse.fit, None, collapse
    if not law:
        return fitting.fit(films, known, also, **how), None, None
    if len(law) == 1:
        return model_selection.fit_law(films, known, law[0], also_free=also, **how), None, None
    compared = model_selection.fit_laws(films, known, law, also_free=also, **how)
    return compared.best, compared, None


def _priors(texts: list[str]) -> dict[str, str]:
    """Read ``name=distribution(...)``."""
    found: dict[str, str] = {}
    for text in texts:
        name, equals, law = (part.strip() for part in text.partition("="))
        if not name or not equals or not law:
            form = "write a name and a distribution, such as 'viscosity=lognorm(s=0.5, scale=30 Pa*s)'"
            raise typer.BadParameter(f"{text!r} is no prior: {form}", param_hint="--prior")
        if name in found:
            raise typer.BadParameter(f"{name} has two priors", param_hint="--prior")
        found[name] = law
    return found


def _bounds(texts: list[str]) -> dict[str, tuple[object, object]]:
    """Read ``name=low:high unit``."""
    found: dict[str, tuple[object, object]] = {}
    for text in texts:
        name, _, pair = (part.strip() for part in text.partition("="))
        ends = cli.read_pair(pair)
        if not name or ends is None:
            raise typer.BadParameter(f"{text!r} are no bounds: {_FORM}", param_hint="--bounds")
        if name in found:
            raise typer.BadParameter(f"{name} is bounded twice", param_hint="--bounds")
        found[name] = ends
    return found
