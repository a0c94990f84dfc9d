"""The how-to pages show what their notebooks print and draw; built as README says, without a warning."""

from __future__ import annotations

import html
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.slow

ROOT = Path(__file__).parents[2]
SHOWN = {
    "12_own_rheology": "",
    "13_first_run": "expected: descending",
    "14_ink_bridging": "",
    "15_fit_your_data": "",
    "16_take_the_c_away": "",
}
"""Each has pictures and printed text; of one, what it must print."""


def test_how_to_pages_show_their_outputs(tmp_path: Path) -> None:
    before = os.times()
    command = [sys.executable, "-m", "sphinx", "-W", "-q", "-b", "html", ".docs", str(tmp_path)]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False, timeout=900)
    after = os.times()
    assert done.returncode == 0, done.stdout + done.stderr
    print(f"\nbuilt in {after.children_user - before.children_user:.0f} s of the processor")
    for name, wanted in SHOWN.items():
        page = (tmp_path / "howto" / f"{name}.html").read_text(encoding="utf-8")
        blocks = re.findall(r'<div class="output highlight-text.*?</div>', page, re.DOTALL)
        texts = [html.unescape(re.sub(r"<[^>]+>", "", block)).strip() for block in blocks]
        pictures = re.findall(r'<img class="output"[^>]* src="data:image/png;base64,\w', page)
        print(f"{name:20} {len(texts)} texts, {len(pictures)} pictures")
        assert texts
        assert pictures
        assert any(text.startswith(wanted) for text in texts)
        assert not any("Traceback" in text for text in texts)
