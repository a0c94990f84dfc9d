"""``softcat span``: the longest gap that a filament spans."""

from __future__ import annotations

from softcat_sym.cli import application as cli
from softcat_sym.lazy import lazy_imports
from softcat_sym.progress import StudyDisplay

with lazy_imports():
    from softcat_sym.design import critical_span


def span(
    scene: cli.SceneArgument,
    max_sag: cli.MaxSagOption = "5 %",
    output: cli.OutputOption = None,
    fresh: cli.FreshOption = False,
    changes: cli.SetOption = None,
    quiet: cli.QuietOption = False,
) -> None:
    """Find the longest gap that a filament spans with a sag below a limit.

    The first line is the span and its error, the next what limits it; DIR gets span.json, span.csv (the spans that were
    tried), span.png, and the scene at that span. The sag is the largest during the run.
    """
    asked, output = cli.scene_and_directory(scene, changes, output, "span")
    with cli.study(fresh=fresh), StudyDisplay(quiet=quiet) as progress:
        found = critical_span.longest_span(asked, max_sag, progress)
    cli.present(found, output, quiet=quiet, scene=asked)
