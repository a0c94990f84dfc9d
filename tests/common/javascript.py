"""The page's model.js in whatever runs JavaScript here: V8 within Python (mini-racer), or node."""

from __future__ import annotations

import importlib.util
import json
import shutil
import subprocess
from importlib import resources
from pathlib import Path
from typing import Any

import numpy as np
import pytest

NODE = shutil.which("node")
MODEL = resources.files("softcat_sym.web") / "templates" / "model.js"

_READ = 'const given = JSON.parse(require("fs").readFileSync(0, "utf8"))'
_ARRAYS = """\
const unlisted = one => Array.isArray(one) && one.every(x => typeof x === "number") ? Float64Array.from(one)
  : one && typeof one === "object" && !Array.isArray(one)
    ? Object.fromEntries(Object.entries(one).map(([name, part]) => [name, unlisted(part)])) : one
const listed = (_, one) => ArrayBuffer.isView(one) ? Array.from(one) : one
"""


def _plain(value: Any) -> Any:
    return np.asarray(value).ravel().tolist() if isinstance(value, np.ndarray) else value


def evaluated(expression: str, *, in_node: bool = False, **given: Any) -> Any:
    """What an expression of model.js and of `given` makes, through JSON; arrays of numbers in `unlisted(...)`."""
    text = json.dumps(given, default=_plain)
    source = f"{MODEL.read_text(encoding='utf-8')}\n{_ARRAYS}"
    if not in_node and importlib.util.find_spec("py_mini_racer") is not None:
        from py_mini_racer import MiniRacer

        racer = MiniRacer()
        racer.eval(f"{source}\nconst given = JSON.parse({json.dumps(text)})")
        return json.loads(racer.eval(f"JSON.stringify({expression}, listed)"))
    if NODE is None:
        pytest.skip("nothing here runs JavaScript: neither mini-racer nor node")
    answer = f"Promise.resolve({expression}).then(one => console.log(JSON.stringify(one, listed)))"
    found = subprocess.run(
        [NODE, "-e", f"{source}\n{_READ}\n{answer}"], input=text, capture_output=True, text=True, check=False
    )
    assert found.returncode == 0, found.stderr
    return json.loads(found.stdout)


def solved_in_node(data: dict[str, Any], module: Path, states: list[dict[str, Any]], fields: tuple[str, ...]) -> Any:
    """Runs of some states by the page's module, in node, with some of their fields."""
    if NODE is None:
        pytest.skip("node is not here, which runs the module as a browser does")
    kept = "Object.fromEntries(given.fields.filter(name => name in run.fields).map(name => [name, run.fields[name]]))"
    solving = "given.states.map(state => solve(given.data, module, state, given.data.resolution))"
    solving += f".map(run => ({{...run, fields: {kept}}}))"
    code = f'instantiate(require("fs").readFileSync(given.module)).then(module => {solving})'
    return evaluated(code, in_node=True, data=data, module=str(module), states=states, fields=fields)
