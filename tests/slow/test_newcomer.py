"""README, an empty environment, one without a compiler, and the pages of notebooks, as a newcomer meets them.

Environments are made from the registry that pip is set up for; ``pytest -s -m slow`` prints seconds of each step.
"""

from __future__ import annotations

import html
import json
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

from tests.test_packaging import built

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
    """Exit status or ``timeout``, and what it says; prints the former, and seconds of the processor and of the wall."""
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
    return status, said


def test_every_code_block_of_the_readme_runs_as_typed(tmp_path: Path) -> None:
    environment = {**os.environ, "PATH": f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"}
    environment |= {"MPLBACKEND": "agg", "COLUMNS": "100"}
    wrong = []
    print(f"\n{'status':>8} {'processor':>10} {'wall':>7}")
    for command, promised in steps():
        status, said = run(command, tmp_path, environment)
        wrong += [f"{command}\n  {status} in place of {promised}; {said[-1500:]}"] if status != promised else []
    assert not wrong, "\n".join(wrong)


def test_the_readme_installs_twice_and_shows_the_sample() -> None:
    commands = [line.partition(" #")[0] for _, text in BLOCKS for line in text.splitlines()]
    installing = [line for line in commands if "pip install" in line]
    assert ["softcat run" in line or "pytest" in line for line in installing] == [True, True]
    assert len(list(steps())) > 10
    (scene,) = (text for language, text in BLOCKS if language == "toml")
    assert (ROOT / "softcat_sym" / "samples" / "my-ink.toml").read_text(encoding="utf-8") == scene


def elsewhere(folder: Path) -> dict[str, str]:
    """An environment in which neither the libraries nor the modules of who tests are there, nothing compiled before."""
    names = ("PYTHON", "SOFTCAT", "VIRTUAL_ENV")
    kept = {key: value for key, value in os.environ.items() if not key.startswith(names)}
    return kept | {"SOFTCAT_CACHE": str(folder / "cache"), "HOME": str(folder), "PIP_NO_CACHE_DIR": "1"}


def answered(folder: Path, *commands: str) -> list[str]:
    """What commands say that must succeed."""
    said = []
    for command in commands:
        status, text = run(command, folder, elsewhere(folder))
        assert status == 0, text[-1500:]
        said.append(text)
    return said


OWN = "export PATH=$PWD/.venv/bin:$PATH && "
NEW = (
    "softcat new my-ink.toml --span '2 mm' --diameter '0.25 mm' --density '1100 kg/m^3' --youngs-modulus '45 kPa'"
    " --law herschel-bulkley --shear-yield-stress '200 Pa' --shear-consistency '60 Pa*s^0.4' --index 0.4"
    " --surface-tension '40 mN/m' --duration '20 ms'"
)
CURVE = "shear_rate_1_s,shear_stress_Pa\n0.1,222\n0.5,247\n1,258\n5,316\n10,349\n50,489\n100,580\n"
"""What a newcomer types from the screen of a rheometer: 200 Pa + 60 Pa (rate s)^0.4, within 2 %."""


def test_from_a_clone_to_answers_of_ones_own(tmp_path: Path) -> None:
    """README's second command in a clone, then an ink and a flow curve that are typed."""
    found = re.search(r"(?m)^python3 -m venv .*pip install.*softcat run.*$", README)
    assert found is not None
    folder = tmp_path / "softcat_sym"
    answered(tmp_path, f"git clone -q '{ROOT}' '{folder}'")
    (folder / "my-curve.csv").write_text(CURVE, encoding="utf-8")
    answered(folder, found[0], f"{OWN}softcat doctor", OWN + NEW, f"{OWN}softcat run my-ink.toml")
    answered(folder, f"{OWN}softcat flow-curve my-curve.csv --scene my-ink.toml")
    summary = json.loads((folder / "softcat-out" / "my-ink" / "summary.json").read_text(encoding="utf-8"))
    assert summary["outcome"] == "solved" and summary["midpoint_final_m"] < 0
    fitted = json.loads((folder / "softcat-out" / "my-ink-flow-curve" / "flow_curve.json").read_text(encoding="utf-8"))
    assert fitted["best"] == "herschel-bulkley"


def pythons() -> dict[str, str]:
    """Executables by version, from 3.11 on, the one that runs the tests among them."""
    found: dict[str, str] = {}
    for program in (sys.executable, *(f"python3.{minor}" for minor in range(11, 20))):
        if (path := shutil.which(program)) is None:
            continue
        asked = [path, "-c", "import platform; print(platform.python_version())"]
        done = subprocess.run(asked, capture_output=True, text=True, check=False)
        # A name on the path may lead to no Python: pyenv has one for each version that it knows of.
        if done.returncode == 0:
            found.setdefault(done.stdout.strip(), path)
    return found


def test_the_wheel_works_in_an_empty_environment_on_every_python(tmp_path: Path) -> None:
    wheel = built("wheel", tmp_path)
    for version, python in pythons().items():
        folder = tmp_path / version
        folder.mkdir()
        install = f"{python} -m venv --clear .venv && .venv/bin/python -m pip install -q '{wheel}'"
        answered(folder, install, f"{OWN}softcat doctor", f"{OWN}softcat run arrested-overdamped -q -o out")
        assert (folder / "out" / "summary.json").is_file()


ADVICE = "pip install 'softcat_sym[compiler]'"


def test_zig_takes_the_place_of_a_compiler_and_its_absence_says_how_to_have_it(tmp_path: Path) -> None:
    """A PATH without a C compiler: with the extra `compiler` runs are compiled by zig, without it interpreted."""
    answered(tmp_path, f"{sys.executable} -m venv .venv && .venv/bin/python -m pip install -q '{ROOT}[compiler]'")
    own, zig, none = found = [tmp_path / name for name in ("own", "zig", "none")]
    command = ".venv/bin/softcat run ink-bridge --no-pictures --set numerics.estimate=false -o"
    bare = f"export PATH={tmp_path}/.venv/bin COLUMNS=200"
    said = answered(tmp_path, f"{command} {own}")
    said += answered(tmp_path, f"{bare} SOFTCAT_CACHE={tmp_path}/zigs; {command} {zig}")
    answered(tmp_path, ".venv/bin/python -m pip -q uninstall --yes ziglang")
    said += answered(tmp_path, f"{bare} SOFTCAT_CACHE={tmp_path}/none; {command} {none}")
    runs = [json.loads((one / "summary.json").read_text(encoding="utf-8")) for one in found]
    assert [one["backend"] for one in runs] == ["compiled", "compiled", "interpreted"]
    assert "clang" in runs[1]["backend_reason"] and ADVICE in runs[2]["backend_reason"]
    assert [ADVICE in screen for screen in said] == [False, False, True]
    for other, steps in ((runs[1], 1), (runs[2], 10)):
        assert other["midpoint_final_m"] == pytest.approx(runs[0]["midpoint_final_m"], rel=steps * runs[0]["rtol"])


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
