"""README and the pages of notebooks, as a newcomer meets them; ``pytest -s -m slow`` prints seconds of each step.

The stopwatch runs from a clone to the answer for a filament of one's own: it installs from the registry that pip is set
up for, and compiles into a cache of its own.
"""

from __future__ import annotations

import html
import json
import math
import os
import re
import resource
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.common.table import show

pytestmark = pytest.mark.slow

ROOT = Path(__file__).parents[2]
README = (ROOT / "README.md").read_text(encoding="utf-8")
BLOCKS: list[tuple[str, str]] = re.findall(r"(?ms)^```(\w+)\n(.*?)^```", README)
"""Language and text of every fenced block."""
LIMIT = 900.0
"""Seconds of the wall in which a line must end."""


def steps() -> Iterator[tuple[str, int]]:
    """Every line but those that install or need it, and the exit status promised; a program is run from a file."""
    for language, text in BLOCKS:
        if language == "sh":
            for line in text.replace("\\\n", " ").splitlines():
                if line.strip() and not line.startswith("#") and "pip install" not in line:
                    promised = re.search(r"#.*exit status (\d+)", line)
                    yield line, int(promised[1]) if promised else 0
        elif language == "toml":
            yield f"cat > my-ink.toml <<'END'\n{text}END\nsoftcat run my-ink.toml", 0
        elif language == "python":
            yield f"{sys.executable} - <<'END'\n{text}END", 0
        else:
            yield f"echo 'a block of {language} is not run'; false", 0


def run(command: str, folder: Path, environment: dict[str, str]) -> tuple[int | str, str]:
    """Exit status or ``timeout``, and the last words; prints both, and seconds of the processor and of the wall."""
    before, began = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    shell = subprocess.Popen(
        ["bash", "-c", command],
        cwd=folder,
        env=environment,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        start_new_session=True,
    )
    status: int | str
    try:
        said, _ = shell.communicate(timeout=LIMIT)
        status = shell.returncode
    except subprocess.TimeoutExpired:
        os.killpg(shell.pid, signal.SIGKILL)
        said, _ = shell.communicate()
        status = "timeout"
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    spent = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    wall = time.monotonic() - began
    print(f"{status!s:>8} {spent:8.1f} s {wall:5.0f} s  {command.splitlines()[0][:80]}", flush=True)
    return status, said[-1500:]


def test_every_code_block_of_the_readme_runs_as_typed(tmp_path: Path) -> None:
    environment = {**os.environ, "PATH": f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"}
    environment |= {"MPLBACKEND": "agg", "COLUMNS": "100"}
    wrong = []
    print(f"\n{'status':>8} {'processor':>10} {'wall':>7}")
    for command, promised in steps():
        status, said = run(command, tmp_path, environment)
        wrong += [f"{command}\n  {status} in place of {promised}; {said}"] if status != promised else []
    assert not wrong, "\n".join(wrong)


def test_the_readme_installs_twice_and_shows_the_sample() -> None:
    commands = [line.partition(" #")[0] for _, text in BLOCKS for line in text.splitlines()]
    installing = [line for line in commands if "pip install" in line]
    assert ["softcat run" in line or "pytest" in line for line in installing] == [True, True]
    assert len(list(steps())) > 10
    (scene,) = (text for language, text in BLOCKS if language == "toml")
    assert (ROOT / "softcat_sym" / "samples" / "my-ink.toml").read_text(encoding="utf-8") == scene


OWN = "export PATH=$PWD/.venv/bin:$PATH && "
NEW = (
    "softcat new my-ink.toml --span '2 mm' --diameter '0.25 mm' --density '1100 kg/m^3' --youngs-modulus '45 kPa'"
    " --law herschel-bulkley --shear-yield-stress '200 Pa' --shear-consistency '60 Pa*s^0.4' --index 0.4"
    " --surface-tension '40 mN/m' --duration '20 ms'"
)
CURVE = "shear_rate_1_s,shear_stress_Pa\n0.1,222\n0.5,247\n1,258\n5,316\n10,349\n50,489\n100,580\n"
"""What a newcomer types from the screen of a rheometer: 200 Pa + 60 Pa (rate s)^0.4, within 2 %."""
FIT = (
    "softcat fit film.csv --scene sample.toml --free viscosity --free yield_stress --calibrated --no-profile-likelihood"
)


def test_from_a_clone_to_answers_of_ones_own(tmp_path: Path) -> None:
    """The stopwatch: what is typed, and the seconds of each step; nothing is compiled or downloaded before."""
    found = re.search(r"(?m)^python3 -m venv .*pip install.*softcat run.*$", README)
    assert found is not None
    install, _, first_run = found[0].rpartition(" && ")
    folder = tmp_path / "softcat_sym"
    # Neither the libraries nor the modules of who tests are there for a newcomer.
    environment = {name: text for name, text in os.environ.items() if name not in ("PYTHONPATH", "VIRTUAL_ENV")}
    environment |= {"SOFTCAT_CACHE": str(tmp_path / "cache"), "PIP_NO_CACHE_DIR": "1"}
    path = {
        "clone": f"git clone -q '{ROOT}' '{folder}'",
        "install": install,
        "run": first_run,
        "check": f"{OWN}softcat doctor",
        "own ink": OWN + NEW,
        "its sag": f"{OWN}softcat run my-ink.toml",
        "own CSV of a flow curve": f"{OWN}softcat flow-curve my-curve.csv --scene my-ink.toml",
        "CSV of a film": OWN + FIT,
        "card": f"{OWN}softcat card my-ink.toml",
        "page: compiler": ".venv/bin/pip install -q ziglang",
        "page": f"{OWN}softcat generate my-ink.toml --web -o page",
    }
    rows, began = [], time.monotonic()
    for step, command in path.items():
        start, before = time.monotonic(), os.times()
        status, said = run(command, folder if folder.exists() else tmp_path, environment)
        assert status == 0, said
        after, wall = os.times(), time.monotonic() - start
        spent = sum(after[2:4]) - sum(before[2:4])
        typed = command.removeprefix(OWN).replace(f" '{folder}'", "").replace(f"'{ROOT}'", "ADDRESS")
        rows.append((step, f"`{typed}`", f"{wall:.1f}", f"{spent:.1f}"))
        if step == "check":
            # The newcomer's own files: a curve that is typed, a film that is at hand.
            (folder / "my-curve.csv").write_text(CURVE, encoding="utf-8")
            shutil.copy(folder / "softcat_sym" / "samples" / "film.csv", folder)
            shutil.copy(folder / "softcat_sym" / "samples" / "my-ink.toml", folder / "sample.toml")
    rows.append(("together", "", f"{time.monotonic() - began:.0f}", ""))
    show("A newcomer's path", ("step", "typed", "s", "s of the processor"), rows)
    out = folder / "softcat-out"
    summary = json.loads((out / "my-ink" / "summary.json").read_text(encoding="utf-8"))
    assert summary["outcome"] == "solved"
    assert summary["midpoint_final_m"] < 0
    fitted = json.loads((out / "my-ink-flow-curve" / "flow_curve.json").read_text(encoding="utf-8"))
    assert fitted["best"] == "herschel-bulkley"
    assert (out / "my-ink-card" / "card.html").is_file() and (folder / "page" / "my-ink.html").is_file()
    # The film is of an ink of 200 Pa in shear; it does not tell the viscosity, which the fit says.
    material = json.loads((out / "sample-fit" / "fit.json").read_text(encoding="utf-8"))["parameters"]
    low, high = material["yield_stress"]["ci95"]
    assert low < 200 * math.sqrt(3) < high


PAGES = {
    "howto/12_own_rheology": "",
    "tutorials/13_first_run": "expected: descending",
    "tutorials/14_ink_bridging": "",
    "tutorials/15_fit_your_data": "",
    "howto/16_take_the_c_away": "",
}
"""Pages of notebooks; each has pictures and printed text; of one, what it must print."""


def test_pages_of_notebooks_show_what_these_print_and_draw(tmp_path: Path) -> None:
    """Built as CONTRIBUTING says, without a warning."""
    status, said = run(f"{sys.executable} -m sphinx -W -q -b html .docs {tmp_path / 'pages'}", ROOT, dict(os.environ))
    assert status == 0, said
    for name, expected in PAGES.items():
        page = (tmp_path / "pages" / f"{name}.html").read_text(encoding="utf-8")
        blocks = re.findall(r'<div class="output .*?</pre>', page, re.DOTALL)
        texts = [html.unescape(re.sub(r"<[^>]+>", "", block)).strip() for block in blocks]
        pictures = re.findall(r'<img alt="[^"]*" src="../_images/[0-9a-f]{16,}\.png"', page)
        print(f"{name:26} {len(texts)} texts, {len(pictures)} pictures")
        assert texts and pictures
        assert any(text.startswith(expected) for text in texts)
        assert not any("Traceback" in text for text in texts)
