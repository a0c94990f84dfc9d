"""The live page as a file: its policy knows its scripts, its words are inert, it loads nothing, and it stays small."""

from __future__ import annotations

import base64
import hashlib
import json
import re
from html import unescape

from tests.common.parabola import page

WORD = """</script><script>alert("1")</script>"' & <b> @DATA@ @POLICY@"""


def test_the_policy_lets_in_what_the_page_holds_and_nothing_else():
    text = page()
    found = re.search(r'<meta http-equiv="Content-Security-Policy" content="([^"]*)">', text)
    assert found is not None
    assert text.index(found[0]) < text.index("<style") < text.index("<script"), "a policy holds from where it stands"
    policy = dict(part.split(" ", 1) for part in found[1].split("; "))
    run = re.findall(r'<script(?: id="model")?>(.*?)</script>', text, flags=re.S)
    styles = re.findall(r"<style>(.*?)</style>", text, flags=re.S)
    assert (len(run), len(styles)) == (2, 1)
    hashes = [f"'sha256-{base64.b64encode(hashlib.sha256(one.encode()).digest()).decode()}'" for one in (*run, *styles)]
    assert policy == {
        "default-src": "'none'",
        "script-src": f"{hashes[0]} {hashes[1]} 'wasm-unsafe-eval'",
        "worker-src": "blob:",
        "style-src": hashes[2],
        "img-src": "data: blob:",
        "base-uri": "'none'",
        "form-action": "'none'",
    }
    assert not re.search(r" style=| on[a-z]+=", text.split("<script")[0]), "the policy would refuse it"


def test_a_title_is_text_wherever_it_stands():
    text = page(WORD)
    assert text.count("<script") == text.count("</script>") == 5
    assert all(unescape(one) == WORD for one in re.findall(r"<(?:title|h1 id=\"title\")>(.*?)</", text))
    held = re.findall(r'<script type="application/json" id="data">(.*?)</script>', text, flags=re.S)
    assert json.loads(held[0])["title"] == WORD
    assert "<title>strand</title>" in page("  "), "one without a title has its name"
