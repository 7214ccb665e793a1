# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""The notebooks of examples/notebooks run from their first cell to the last; so do the README's lines."""
import json
import pathlib
import re

import pytest

ROOT = pathlib.Path(__file__).parents[2]
NOTEBOOKS = sorted((ROOT / "examples" / "notebooks").glob("*.ipynb"))


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda p: p.stem)
def test_notebook_runs(path):
    scope = {}
    for cell in json.loads(path.read_text())["cells"]:
        if cell["cell_type"] == "code":
            exec(compile("".join(cell["source"]), f"{path.name}, {cell['id']}", "exec"), scope)


def test_there_are_notebooks():
    assert {p.stem for p in NOTEBOOKS} >= {"board", "nest", "fixture", "insertion", "packing", "phi"}


def test_readme_lines_run(capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    pytest.importorskip("matplotlib").use("Agg")
    lines = re.search(r"```python\n(.*?)```", (ROOT / "README.md").read_text(), re.S)[1]
    exec(lines, {})
    assert capsys.readouterr().out.startswith("[[50. 30.]]")
    assert (tmp_path / "region.png").stat().st_size > 1000


def test_lines_of_the_library_page_run(capsys, monkeypatch):
    monkeypatch.chdir(ROOT)
    for lines in re.findall(r"```python\n(.*?)```", (ROOT / "docs" / "library.md").read_text(), re.S):
        exec(lines, {})
    said = capsys.readouterr().out
    assert said.startswith("yes 1793.4 ") and "[<A at [0.0, 0.0]>, <A at [9.0, 0.0]>" in said


def test_lines_of_the_nesting_page_run(capsys):
    for lines in re.findall(r"```python\n(.*?)```", (ROOT / "docs" / "nesting.md").read_text(), re.S):
        exec(lines, {})
    sheets, rings, plugs, by_hand, solids = capsys.readouterr().out.splitlines()
    assert sheets.startswith("['plate") and sheets.endswith(" []")
    length, *remnant = re.findall(r"[\d.]+", rings)
    assert float(length) <= 37 and len(remnant) == 4
    assert "('plug', ('2', '0.5'))" in plugs and plugs.endswith(" []")
    assert by_hand.startswith("[('overlap', ['ell#1', 'ell#2'])]") and by_hand.endswith(" True")
    assert " (4, 4) " in solids and solids.endswith(" []")
