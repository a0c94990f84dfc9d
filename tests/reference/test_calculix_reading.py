"""Print-outs of CalculiX, whole and broken."""

from __future__ import annotations

import numpy as np
import pytest

from softcat_sym.errors import SoftcatError
from softcat_sym.reference.calculix import read_displacements, read_status

BLOCK = """
 displacements (vx,vy,vz) for set CENTRE and time  {time}

         3  0.000000E+00 -1.250000E-01  1.000000-101
        17  2.500000E-03 -5.000000E-02  0.000000E+00
"""
NODES = np.array([17, 3], dtype=np.int32)
STATUS = """SUMMARY OF JOB INFORMATION
  STEP      INC     ATT  ITRS     TOT TIME     STEP TIME      INC TIME
     1          1     1     2  0.217945E-04  0.217945E-04  0.217945E-04
     1          2     1U    4  0.217945E-04  0.217945E-04  0.217945E-02
     1          2     2     3  0.406467E-01  0.406467E-01  0.544862E-03
     1          3     1     2  0.411916E-01  0.411916E-01  0.54"""


def test_displacements_come_in_the_order_asked() -> None:
    text = BLOCK.format(time="0.1000000E-01") + BLOCK.format(time="0.2000000E-01")
    found = read_displacements(text, NODES, np.array([0.01, 0.02]))
    assert found.shape == (2, 2, 3)
    assert found[1] == pytest.approx(np.array([[2.5e-3, -0.05, 0.0], [0.0, -0.125, 1e-101]]), abs=1e-30)


def test_what_is_missing_is_said() -> None:
    text = BLOCK.format(time="0.1000000E-01")
    with pytest.raises(SoftcatError, match=r"1 of 2 output times; the last is 0\.01 s of 0\.02 s"):
        read_displacements(text, NODES, np.array([0.01, 0.02]))
    with pytest.raises(SoftcatError, match="1 of 1 output times"):
        read_displacements(text, NODES, np.array([0.011]))
    with pytest.raises(SoftcatError, match="every node"):
        read_displacements(text, np.array([3, 18], dtype=np.int32), np.array([0.01]))
    with pytest.raises(SoftcatError, match="0 of 1 output times"):
        read_displacements("", NODES, np.array([0.01]))


def test_failed_and_unfinished_increments_do_not_count() -> None:
    assert read_status(STATUS) == (2, 0.0406467, 5.44862e-4)
    assert read_status("") == (0, 0.0, 0.0)
