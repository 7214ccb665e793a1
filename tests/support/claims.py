#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Every cell of the support table, asked of the program with small scenes.

usage: claims.py EXECUTABLE quick|slow [--list]

`quick` takes the cells whose cost is quick or fast, and those without a cost; `slow` takes the others. The table is the
one that `EXECUTABLE help support --markdown` prints, and docs/support.md must be that page. Each question of the
table has an entry in questions.py, and each entry there a question.

What a cell claims, the answer must show:

  exact      an answer, and nothing in it that says otherwise (MARKS)
  enclosed   an answer; of maps on lines one says on which side it errs
  inner ..   an answer between bounds, or one that is not proven
  refused    exit status 3, with a message of that kind (KINDS)
  on lines   lines instead of an exact map"""
import json
import os
import re
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor

from questions import ALSO, IN_PLANE, IN_SPACE

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SECONDS = int(os.environ.get("CASE_SECONDS", "600"))  # for one answer
MARKS = ("outer", "bound", "bounds", "within")  # of a result that is not exact; and lower, upper of a value
EXACT = {"exact", "exact, one distance"}
UNMARKED = "nothing says that the lines have an error"
KINDS = {
    "not computed": "(is|are) not computed|rotation is about",
    "no least value": "has no least value",
    "slanted faces": "faces are all parallel to the axes",
}


# --- the table, and what the program answers ---------------------------------------------------------------------------

def plain(text):
    return re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", text).replace("`", "")


def cells(page):
    """(dimension, group, question, class, answer, cost) of every cell of the page."""
    dimension, group, classes = "", "", []
    for line in page.splitlines():
        if line.startswith("## "):
            dimension = {"## In the plane": "plane", "## In space": "space"}.get(line, "")
        elif line.startswith("### "):
            group, classes = plain(line[4:]), []
        elif line.startswith("| query |"):
            classes = [c.strip() for c in line.split("|")[2:-1]]
        elif line.startswith("|---"):
            continue
        elif line.startswith("| ") and classes:
            row = [c.strip() for c in line.split("|")[1:-1]]
            for shapes, cell in zip(classes, row[1:], strict=True):
                answer, _, cost = cell.partition(" · ")
                yield dimension, group, plain(row[0]), shapes, answer, cost
        else:
            classes = []


def keys(value):
    """Every key of a result, however deep."""
    if isinstance(value, dict):
        yield from value
    for item in value.values() if isinstance(value, dict) else value if isinstance(value, list) else ():
        yield from keys(item)


def marks(result):
    """What in a result says that it is not exact."""
    found = {key for key in MARKS if key in result} | {"lower", "upper"} & set(keys(result))
    if result.get("side") in ("inner", "outer"):
        found.add("side")
    if result.get("proven") is False:
        found.add("not proven")
    if result.get("rays", {}).get("on_lines", "exact") != "exact":
        found.add("lines with an error")
    return found


def ask(executable, args, scene_value):
    run = subprocess.run([executable, *args, "--json", "-q"], input=json.dumps(scene_value), capture_output=True,
                         text=True, timeout=SECONDS, check=False)
    return run.returncode, run.stdout, run.stderr


def fault(group, query, claim, status, out, message):
    """Why an answer is not what the cell claims, or None."""
    if claim.startswith("refused: "):
        wanted = KINDS[claim[len("refused: "):]]
        return None if status == 3 and re.search(wanted, message) else f"not refused as '{wanted}': {status} {message}"
    if claim == "enclosed; truth may be refused" or claim == "refused near the level":
        return None if status in (0, 1) or "decide" in message else f"exit status {status}: {message}"
    if status not in (0, 1, 4):
        return f"exit status {status}: {message}"
    result = json.loads(out)
    found = marks(result)
    if query == "poses: each angle, rotated vertices on the grid":
        return None if result["poses"] and not any(marks(pose) for pose in result["poses"]) else "no exact poses"
    if query == "poses: between two angles":
        return None if all({"inner", "outer"} <= set(s) for s in result["sectors"]) else "no sectors"
    if query == "nearest feasible position" and claim in ("exact", "–"):
        given = result.get("nearest_feasible") is not None
        return None if given == (claim == "exact") else f"nearest position given: {given}"
    if claim in EXACT:
        return f"not exact: {sorted(found)}" if found else None
    if claim == "enclosed" and group.startswith("Sums"):
        return None if result["bound"] <= result["minimum"] and result["attained"] else "no certified bound"
    if claim == "inner, outer":
        return None if found else "nothing says that the answer is between bounds"
    if claim.startswith("inner"):
        return None if "not proven" in found else "nothing says that the answer is not proven"
    if claim == "on lines":
        return None if "rays" in result else "no lines"
    if claim == "enclosed 2^-30" and group == "Maps on lines":
        return None if found else UNMARKED
    return None


def look(executable, cell):
    dimension, group, query, shapes, claim, _ = cell
    start, found, asked = time.time(), [], 0
    questions = (IN_PLANE if dimension == "plane" else IN_SPACE)[group][query]
    for args, value in (one for kind in [shapes, *ALSO.get(shapes, [])] for one in questions(kind)):
        try:
            why = fault(group, query, claim, *ask(executable, args, value))
        except subprocess.TimeoutExpired:
            why = f"no answer in {SECONDS} seconds"
        if why:
            found.append(f"{value.get('where', '')} {why.strip()}")
        asked += 1
    if found and len(found) < asked and all(why.endswith(UNMARKED) for why in found):
        found = []  # the cell states the worst of its distances
    return cell, found, time.time() - start


def main():
    if len(sys.argv) < 3 or sys.argv[2] not in ("quick", "slow"):
        sys.exit("usage: claims.py EXECUTABLE quick|slow [--list]")
    executable, slow = os.path.abspath(sys.argv[1]), sys.argv[2] == "slow"
    page = subprocess.run([executable, "help", "support", "--markdown"], capture_output=True, text=True, check=True).stdout
    with open(os.path.join(ROOT, "docs", "support.md"), encoding="utf-8") as file:
        if file.read() != page:
            sys.exit("docs/support.md is not the table of the program: findspace help support --markdown > docs/support.md")
    table = list(cells(page))
    asked = {("plane", g, q) for g, all_of in IN_PLANE.items() for q in all_of} | \
            {("space", g, q) for g, all_of in IN_SPACE.items() for q in all_of}
    stated = {cell[:3] for cell in table}
    if asked != stated:
        sys.exit(f"in the table alone: {sorted(stated - asked)}; asked alone: {sorted(asked - stated)}")
    chosen = [cell for cell in table if (cell[5] in ("slow", "long") or "on lines" in cell[4]) == slow]
    failed = 0
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        for cell, faults, seconds in pool.map(lambda c: look(executable, c), chosen):
            if "--list" in sys.argv:
                print(f"{seconds:6.2f} s", *cell, sep=" | ")
            for why in faults:
                print("FAIL", *cell, why, sep=" | ")
            failed += bool(faults)
    print(f"{len(chosen) - failed} cells hold, {failed} do not")
    return 1 if failed or not chosen else 0


if __name__ == "__main__":
    sys.exit(main())
