"""The units that are known without pint are pint's, to the last bit; scenes written in them never load it."""

from __future__ import annotations

import subprocess
import sys

from softcat_sym.scene.units import COMMON, SI_UNITS, measured_by_pint


def test_each_is_what_pint_measures() -> None:
    for unit in COMMON:
        assert COMMON[unit] == measured_by_pint(unit, "one of mass, length and time")


def test_every_si_unit_is_known() -> None:
    assert set(SI_UNITS.values()) <= set(COMMON)


def test_a_scene_in_common_units_does_not_wait_for_pint() -> None:
    code = "import sys, softcat_sym as sc; sc.load_scene('arrested-overdamped'); assert 'pint' not in sys.modules"
    subprocess.run([sys.executable, "-c", code], check=True)
