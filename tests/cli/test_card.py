"""``softcat card`` as a user meets it: a scene or flags, files, one screen, and what is refused."""

from __future__ import annotations

import csv
import json
import re
from pathlib import Path

import pytest

import softcat_sym as sc
from softcat_sym.studies.card import scene_from_flags
from tests.cli.in_process import Softcat, sets

FILES = {"card.html", "card.json", "card.csv", "card.png", "scene.toml"}
BODY = ("--density", "1000 kg/m^3", "--span", "10 cm", "--diameter", "1 mm")
OIL = (*BODY, "--law", "newtonian", "--viscosity", "1 GPa*s", "--duration", "1 s")
INK = (*BODY, "--law", "bingham", "--youngs-modulus", "1 MPa", "--viscosity", "1 kPa*s", "--yield-stress", "3 kPa")
CURVE = "shear_rate_1_s,shear_stress_Pa\n" + "".join(f"{rate},{200 + 10 * rate}\n" for rate in (0.1, 1, 3, 10, 30, 100))


@pytest.fixture
def softcat(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Softcat:
    return Softcat(monkeypatch, capsys)


def test_flags_make_a_page(softcat: Softcat, tmp_path: Path) -> None:
    done = softcat("card", *OIL, "--sag", "0.1 mm", *sets("numerics.cells=10"), "-o", str(tmp_path))
    assert done.status == 0, done.err
    assert {path.name for path in tmp_path.iterdir()} == FILES
    assert len(done.out.splitlines()) <= 45
    assert "It flows for as long as it is loaded." in done.out
    found = json.loads((tmp_path / "card.json").read_text())
    assert found["outcome"] == "solved" and found["regime"] == "viscous"
    rules = {one["key"]: one for one in found["rules"]}
    # Sagging by less than a tenth of its thickness it is a viscous beam; the other rules say why they are not for it.
    assert abs(rules["viscous-beam"]["error"]) < 0.05 and rules["viscous-beam"]["text"] == "holds"
    assert rules["smay-pinned"]["predicted"] is None and "no modulus" in rules["smay-pinned"]["text"]
    rows = list(csv.DictReader((tmp_path / "card.csv").read_text().splitlines()))
    assert [row["rule"] for row in rows] == [one["name"] for one in found["rules"]]
    assert float(rows[3]["predicted"]) == rules["viscous-beam"]["predicted"]
    # The span it names sags as much as it may, and no more.
    span = found["longest_span"]["span_m"]
    scene = sc.load_scene(str(tmp_path / "scene.toml"), {"filament.span": f"{span!r} m"})
    assert -float(sc.simulate(scene).data.midpoint.values[-1]) == pytest.approx(1e-4, rel=0.02)
    page = (tmp_path / "card.html").read_text()
    assert not re.search(r"(src|href)=\"(?!data:)", page) and "http" not in page
    assert "--viscosity &#39;1 GPa*s&#39;" in page


def test_a_flow_curve_is_a_material_in_tension(tmp_path: Path) -> None:
    curve = tmp_path / "curve.csv"
    curve.write_text(CURVE)
    names = [word.removeprefix("--") for word in BODY[::2]]
    flags = dict(zip(names, BODY[1::2], strict=True)) | {"flow-curve": str(curve), "youngs-modulus": "1 MPa"}
    scene, notes = scene_from_flags(flags)
    assert scene.material.law == "bingham" and scene.material.youngs_modulus == 1e6
    assert scene.material.yield_stress == pytest.approx(200 * 3**0.5, rel=1e-3)
    assert scene.material.viscosity == pytest.approx(30, rel=1e-3)
    assert any("converted to tension" in note for note in notes)
    # Twenty swings of sqrt(L/g), and five times eta/sigma_Y.
    assert scene.run.duration == pytest.approx(20 * (0.1 / 9.81) ** 0.5 + 5 * 30 / (200 * 3**0.5), rel=0.01)
    assert any("--duration gives another" in note for note in notes)
    forced, _ = scene_from_flags({**flags, "law": "herschel-bulkley", "duration": "3 s", "ends": "pinned"})
    assert (forced.material.law, forced.run.duration, forced.ends.left) == ("herschel-bulkley", 3.0, "pinned")


def without(name: str, flags: tuple[str, ...] = INK) -> tuple[str, ...]:
    place = flags.index(name)
    return flags[:place] + flags[place + 2 :]


BAD = {
    "nothing": ((), "name a scene"),
    "both": (("ink-bridge", "--density", "1 kg/m^3"), "a scene and --density"),
    "no such scene": (("ink-brigde",), "did you mean 'ink-bridge'"),
    "no density": (without("--density"), "--density: missing"),
    "no span": (without("--span"), "--span: missing"),
    "no diameter": (without("--diameter"), "--diameter: missing"),
    "no law": (without("--law"), "--law: missing"),
    "unknown law": ((*without("--law"), "--law", "binghan"), "bingham"),
    "no viscosity": (without("--viscosity"), "--viscosity: missing: the law 'bingham' needs it"),
    "newtonian without viscosity": ((*BODY, "--law", "newtonian"), "--viscosity: missing"),
    "no modulus": (without("--youngs-modulus"), "--youngs-modulus: missing"),
    "wrong unit": ((*without("--span"), "--span", "10 Pa"), "filament.span"),
    "no unit": ((*without("--span"), "--span", "10"), "filament.span"),
    "negative density": ((*without("--density"), "--density", "-1 kg/m^3"), "filament.density"),
    "thicker than long": ((*without("--diameter"), "--diameter", "1 m"), "filament.thickness"),
    "odd ends": ((*INK, "--ends", "glued"), "ends.left"),
    "index in words": ((*INK, "--index", "thin"), "material.index"),
    "duration 0": ((*INK, "--duration", "0 s"), "run.duration"),
    "set": ((*INK, *sets("material.visosity=1 Pa*s")), "material.visosity"),
    "negative sag": ((*INK, "--sag", "-1 mm"), "sag"),
    "sag in Pa": ((*INK, "--sag", "1 Pa"), "sag"),
    "sag in words": ((*INK, "--sag", "little"), "sag"),
    "sag without span": ((*INK, "--no-span", "--sag", "1 mm"), "--no-span"),
    "sag of no span": ((*OIL, *sets("numerics.cells=6"), "--sag", "900 m"), "limit"),
    "no such curve": ((*BODY, "--flow-curve", "none.csv", "--youngs-modulus", "1 MPa"), "none.csv"),
    "curve without modulus": ((*BODY, "--flow-curve", "CURVE"), "says nothing about the modulus"),
    "broken curve": ((*BODY, "--flow-curve", "BROKEN", "--youngs-modulus", "1 MPa"), "shear_stress_pa"),
    "curve and viscosity": (
        (*BODY, "--flow-curve", "CURVE", "--youngs-modulus", "1 MPa", "--viscosity", "1 Pa*s"),
        "twice",
    ),
    "curve and no law of it": (
        (*BODY, "--flow-curve", "CURVE", "--youngs-modulus", "1 MPa", "--law", "maxwell"),
        "maxwell",
    ),
}


@pytest.mark.parametrize("case", BAD)
def test_bad_input_is_one_clear_error_and_nothing_is_written(softcat: Softcat, tmp_path: Path, case: str) -> None:
    flags, named = BAD[case]
    curves = {"CURVE": CURVE, "BROKEN": "shear_rate_1_s,stress\n1,two\n"}
    for name, text in curves.items():
        (tmp_path / name).write_text(text)
    given = [str(tmp_path / flag) if flag in curves else flag for flag in flags]
    done = softcat("card", *given, "-o", str(tmp_path / "out"))
    print(done.err)
    assert done.status == 2
    assert named.lower() in " ".join(done.err.lower().split())
    assert "Traceback" not in done.err and done.out == ""
    assert not (tmp_path / "out").exists()


def test_a_run_that_is_not_to_be_trusted_says_so_on_top(softcat: Softcat, tmp_path: Path) -> None:
    rough = sets("numerics.cells=4", "run.accuracy=1e-9", "numerics.rtol=1e-3")
    done = softcat("card", *OIL, *rough, "--no-span", "-o", str(tmp_path))
    assert done.status == 1
    assert "Not to be trusted: energy_drift" in done.out.splitlines()[1]
    assert "not sought" in done.out
    assert 'class="verdict doubtful"' in (tmp_path / "card.html").read_text()
    assert json.loads((tmp_path / "card.json").read_text())["outcome"] == "energy_drift"
