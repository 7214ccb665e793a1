#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Packs random small instances and checks every layout in rational arithmetic that knows nothing of the program.

usage: pack_random.py EXECUTABLE [--count N] [--seed S] [--kills N]

Every third instance has sheets, some with an outline that is no rectangle and a hole, and mirrored parts. Half of the
parts may be tilted; their corners are turned and rounded here by a series of many digits.
Checked: every copy of every part or said to be left out, an allowed angle, inside the strip or its sheet, the length as
stated and not below the lower bound, no two parts with a common area, and gaps as wide as asked for. The area is the sum over signed triangles of both parts, each pair clipped
exactly. Then one part of each layout is moved at random, and `findspace verify` must agree with the same check.

With --kills N searches are killed after random times: each leaves a whole feasible layout in its file, or no file."""
import argparse
import json
import os
import random
import signal
import subprocess
import sys
import tempfile
import time
from fractions import Fraction

from pack_refusals import REFUSALS

PI = Fraction("3.14159265358979323846264338327950288419716939937510")


def area(ring):
    return Fraction(sum(a * d - b * c for (a, b), (c, d) in zip(ring, ring[1:] + ring[:1]))) / 2


def clip(polygon, p, q):
    """The part of a convex polygon on the left of the line from p to q."""
    def side(r):
        return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
    result = []
    for a, b in zip(polygon, polygon[1:] + polygon[:1]):
        s, t = side(a), side(b)
        if s >= 0:
            result.append(a)
        if s * t < 0:
            along = Fraction(s) / (s - t)
            result.append((a[0] + along * (b[0] - a[0]), a[1] + along * (b[1] - a[1])))
    return result


def triangles(rings):
    """Signed triangles whose sum is the shape; all counter-clockwise."""
    for ring in rings:
        for a, b in zip(ring, ring[1:] + ring[:1]):
            triangle = [ring[0], a, b]
            twice = area(triangle)
            if twice:
                yield (1, triangle) if twice > 0 else (-1, triangle[::-1])


def common_area(first, second):
    total = Fraction(0)
    for s, t in triangles(first):
        for u, v in triangles(second):
            part = v
            for p, q in zip(t, t[1:] + t[:1]):
                part = clip(part, p, q)
                if len(part) < 3:
                    break
            else:
                total += s * u * area(part)
    return total


def turned(ring, degrees, grid):
    """By an angle in degrees; the corners rounded to the grid, unless that is a multiple of 90."""
    if degrees % 90:
        return [to_grid(x, y, degrees, grid) for x, y in ring]
    for _ in range(int(degrees) // 90 % 4):
        ring = [(-y, x) for x, y in ring]
    return ring


def cosine_and_sine(degrees):
    """To some forty digits, by their series."""
    angle = degrees % 360 * PI / 180
    parts, term = [Fraction(0), Fraction(0)], Fraction(1)
    for k in range(1, 80):
        parts[(k - 1) % 2] += term * (-1 if (k - 1) // 2 % 2 else 1)
        term = Fraction(round(term * angle / k * 10**50), 10**50)
    return parts


def to_grid(x, y, degrees, grid):
    c, s = cosine_and_sine(degrees)
    return tuple(Fraction(round(v / grid)) * grid for v in (c * x - s * y, s * x + c * y))


def box_ring(w, h):
    return [(0, 0), (w, 0), (w, h), (0, h)]


def random_shape(rng):
    """Rings of a part on a small lattice: outer, then holes."""
    kind = rng.randrange(6)
    w, h = rng.randint(1, 6), rng.randint(1, 6)
    if kind == 0:
        return [box_ring(w, h)]
    if kind == 1:
        return [[(0, 0), (w, 0), (rng.randint(0, w), h)]]
    if kind == 2:  # an angle
        a, b = rng.randint(1, 5), rng.randint(1, 5)
        return [[(0, 0), (a + 2, 0), (a + 2, 1), (1, 1), (1, b + 1), (0, b + 1)]]
    if kind == 3:  # a fork
        return [[(0, 0), (3, 0), (3, h + 1), (2, h + 1), (2, 1), (1, 1), (1, h + 1), (0, h + 1)]]
    if kind == 4:  # a frame whose hole others may fit exactly
        return [box_ring(w + 2, h + 2), [(1, 1), (1, h + 1), (w + 1, h + 1), (w + 1, 1)]]
    return [[(0, 0), (w, -1), (w + 2, h), (1, h + rng.randint(0, 2))]]


def moved_somewhere(rng, ring):
    """A place of the origin anywhere, and corners in tenths sometimes."""
    x, y = rng.randint(-4, 4), Fraction(rng.randint(-40, 40), rng.choice([1, 10]))
    return [(Fraction(a) + x, Fraction(b) + y) for a, b in ring]


def instance(rng):
    items = []
    for k in range(rng.randint(1, 5)):
        shape = random_shape(rng)
        shift = moved_somewhere(rng, [(0, 0)])[0]
        rings = [[(a + shift[0], b + shift[1]) for a, b in ring] for ring in shape]
        angles = rng.choice([[0], [0, 180], [0, 90, 180, 270], [90]])
        items.append({"id": f"p{k}", "demand": rng.randint(0, 3) if k else 2, "angles": angles, "rings": rings})
        items[-1]["mirrored"] = rng.random() < 0.3
        items[-1]["tilt"] = rng.choice([0, 0, 2, Fraction(25, 2)])
    gap = rng.choice([0, 0, Fraction(1, 2), Fraction(3, 10)])
    edge = rng.choice([0, 0, Fraction(1, 2)])
    problem = {"height": rng.randint(9, 14) + 2 * edge, "gap": gap, "edge": edge, "items": items, "sheets": []}
    if rng.random() < 0.33:
        problem["sheets"] = [sheet(rng, f"s{k}") for k in range(rng.randint(1, 2))]
    return problem


def sheet(rng, name):
    """A rectangle, or one without a corner, perhaps with a hole."""
    w, h = rng.randint(10, 16), rng.randint(10, 16)
    outline = rng.choice([box_ring(w, h), [(0, 0), (w, 0), (w, h - 3), (w - 4, h), (0, h)],
                          [(0, 0), (w, 0), (w, 4), (6, 4), (6, h), (0, h)]])
    holes = [[(1, 1), (1, 3), (2, 3), (2, 1)]] if rng.random() < 0.4 else []
    return {"id": name, "count": rng.randint(1, 2), "rings": [outline, *holes], "box": (w, h)}


def square_to_segment(p, a, b):
    way, off = (b[0] - a[0], b[1] - a[1]), (p[0] - a[0], p[1] - a[1])
    along = Fraction(way[0] * off[0] + way[1] * off[1]) / (way[0] ** 2 + way[1] ** 2)
    along = min(max(along, Fraction(0)), Fraction(1))
    return (off[0] - along * way[0]) ** 2 + (off[1] - along * way[1]) ** 2


def nearer(first, second, gap):
    """Whether outlines without common inner points are nearer than the gap."""
    def sides(rings):
        return [(a, b) for ring in rings for a, b in zip(ring, ring[1:] + ring[:1])]
    return any(square_to_segment(p, c, d) < gap ** 2 or square_to_segment(c, p, q) < gap ** 2
               for p, q in sides(first) for c, d in sides(second))


def number(value):
    return float(value) if value.denominator > 1 else int(value)


def nesting_json(problem):
    items = []
    for item in problem["items"]:
        rings = [[[number(Fraction(a)), number(Fraction(b))] for a, b in ring] for ring in item["rings"]]
        shape = {"type": "simple_polygon", "data": rings[0]} if len(rings) == 1 else \
            {"type": "polygon", "data": {"outer": rings[0], "inner": rings[1:]}}
        items.append({"id": item["id"], "demand": item["demand"], "allowed_orientations": item["angles"], "shape": shape})
        items[-1]["mirrored"] = item["mirrored"]
        items[-1]["tilt"] = number(Fraction(item["tilt"]))
    result = {"name": "random", "items": items}
    if not problem["sheets"]:
        return {**result, "strip_height": number(Fraction(problem["height"]))}
    sheets = [{"id": s["id"], "count": s["count"], "shape": {"type": "polygon", "data": {
        "outer": s["rings"][0], "inner": s["rings"][1:]}}} for s in problem["sheets"]]
    return {**result, "sheets": sheets}


def placed_rings(problem, item, grid):
    part = next(p for p in problem["items"] if p["id"] == item["part"])
    x, y = (Fraction(v) for v in item["at"])
    rings = [[(-a, b) for a, b in ring][::-1] for ring in part["rings"]] if item["mirrored"] else part["rings"]
    return [[(a + x, b + y) for a, b in turned(ring, Fraction(str(item["angle"])), grid)] for ring in rings]


def outside_sheet(problem, kind, rings):
    """Whether a part has a point outside the sheet, or nearer to its outline or holes than the edge."""
    width, height = kind["box"]
    edge = problem["edge"]
    if any(x < edge or x > width - edge or y < edge or y > height - edge for x, y in rings[0]):
        return True
    frame = [[(-9, -9), (width + 9, -9), (width + 9, height + 9), (-9, height + 9)], kind["rings"][0][::-1]]
    walls = [frame] + [[hole[::-1]] for hole in kind["rings"][1:]]
    return any(common_area(rings, wall) > 0 or (edge and nearer(rings, wall, edge)) for wall in walls)


def sheet_faults(problem, layout, shapes):
    used = layout["container"]["sheets"]
    for kind in problem["sheets"]:
        if used.count(kind["id"]) > kind["count"]:
            yield f"too many of {kind['id']}"
    for item, rings in zip(layout["items"], shapes):
        if item["sheet"] >= len(used):
            yield f"{item['part']} is on no sheet"
        elif outside_sheet(problem, next(k for k in problem["sheets"] if k["id"] == used[item["sheet"]]), rings):
            yield f"{item['part']} is outside"


def is_allowed(part, angle):
    """Within the tilt of one of the angles."""
    off = [(angle - one) % 360 for one in part["angles"]]
    return min(min(by, 360 - by) for by in off) <= part["tilt"]


def grid_of(layout):
    return Fraction(layout["grid"]) if "grid" in layout else None


def faults(problem, layout):
    """What is wrong with a layout, as words."""
    found = []
    length, height = Fraction(layout["length"]), problem["height"]
    shapes = [placed_rings(problem, item, grid_of(layout)) for item in layout["items"]]
    for part in problem["items"]:
        count = sum(item["part"] == part["id"] for item in layout["items"])
        count += sum(out["copies"] for out in layout["left_out"] if out["part"] == part["id"])
        if count != part["demand"]:
            found.append(f"{count} copies of {part['id']}")
    for item, rings in zip(layout["items"], shapes):
        part = next(p for p in problem["items"] if p["id"] == item["part"])
        if not is_allowed(part, Fraction(str(item["angle"]))):
            found.append(f"{item['part']} turned by {item['angle']}")
        if item["mirrored"] and not part["mirrored"]:
            found.append(f"{item['part']} is mirrored")
        edge = problem["edge"]
        if not problem["sheets"] and any(x < edge or x > length - edge or y < edge or y > height - edge for x, y in rings[0]):
            found.append(f"{item['part']} is outside")
    if problem["sheets"]:
        found.extend(sheet_faults(problem, layout, shapes))
    for i, first in enumerate(shapes):
        for j in range(i):
            if layout["items"][i]["sheet"] != layout["items"][j]["sheet"]:
                continue
            if common_area(first, shapes[j]) > 0 or (problem["gap"] and nearer(first, shapes[j], problem["gap"])):
                found.append(f"{layout['items'][i]['part']} and {layout['items'][j]['part']} overlap")
    return found


def run(program, *arguments):
    return subprocess.run([program, *arguments], capture_output=True, text=True, timeout=300, check=False)


def wishes(problem):
    return ["--gap", str(number(Fraction(problem["gap"]))), "--edge", str(number(Fraction(problem["edge"])))]


def fail(seed, text):
    sys.exit(f"pack_random: instance {seed}: {text}")


def check_instance(program, seed, folder):
    rng = random.Random(seed)
    problem = instance(rng)
    path, out = os.path.join(folder, "problem.json"), os.path.join(folder, "layout.json")
    with open(path, "w", encoding="utf-8") as file:
        json.dump(nesting_json(problem), file)
    threads = str(1 + seed % 2)
    packed = run(program, "pack", path, *wishes(problem), "--work", "2", "--threads", threads, "-o", out, "-q", "--json")
    layout = json.loads(packed.stdout)["layout"] if packed.returncode in (0, 1) else fail(seed, packed.stderr)
    if (packed.returncode == 0) != bool(layout["items"]) or (layout["left_out"] and not problem["sheets"]):
        fail(seed, f"status {packed.returncode}")
    if not layout["items"]:
        return
    wrong = faults(problem, layout)
    if wrong:
        fail(seed, "; ".join(wrong))
    last = max(item["sheet"] for item in layout["items"])
    ends = [x for item in layout["items"] if item["sheet"] == last
            for x, _ in placed_rings(problem, item, grid_of(layout))[0]]
    if Fraction(layout["length"]) != max(ends) + problem["edge"]:
        fail(seed, f"length {layout['length']}, but the parts end at {max(ends)}")
    used = last + 1 if problem["sheets"] else Fraction(layout["length"])
    if used < Fraction(layout["lower_bound"]) and not layout["left_out"]:
        fail(seed, "below the lower bound")
    for _ in range(3):
        compare_verdicts(program, seed, folder, path, problem, json.loads(json.dumps(layout)), rng)


def compare_verdicts(program, seed, folder, path, problem, layout, rng):
    """One part moved by little or much: the verdict of the program is that of the check."""
    item = rng.choice(layout["items"])
    step = rng.choice([Fraction(1, 3), Fraction(1), Fraction(1, 10**9), Fraction(0)])
    item["at"] = [str(Fraction(v) + rng.randint(-2, 2) * step) for v in item["at"]]
    if rng.random() < 0.2:
        item["angle"] = rng.choice([0, 90, 180, 270, -90])
    moved = os.path.join(folder, "moved.json")
    with open(moved, "w", encoding="utf-8") as file:
        json.dump({"findspace": 1, "layout": layout}, file)
    verdict = run(program, "verify", moved, path, *wishes(problem))
    expected = 1 if faults(problem, layout) else 0
    if verdict.returncode != expected:
        fail(seed, f"verify says {verdict.returncode}, the check {expected}: {verdict.stdout}{verdict.stderr}{layout}")


def check_interrupt(program, folder):
    """Ctrl-C in a search without limits: status 130, and a whole layout in the file."""
    problem = instance(random.Random(5))
    path, out = os.path.join(folder, "problem.json"), os.path.join(folder, "layout.json")
    with open(path, "w", encoding="utf-8") as file:
        json.dump(nesting_json(problem), file)
    with subprocess.Popen([program, "pack", path, *wishes(problem), "-o", out, "-q"], stdout=subprocess.DEVNULL) as search:
        for _ in range(600):
            if os.path.exists(out):
                break
            time.sleep(0.1)
        search.send_signal(signal.SIGINT)
        if search.wait(timeout=60) != 130:
            fail(5, f"status {search.returncode} after an interrupt")
    with open(out, encoding="utf-8") as file:
        wrong = faults(problem, json.load(file)["layout"])
    if wrong:
        fail(5, "; ".join(wrong))


def check_kills(program, folder, count, rng):
    """SIGKILL at any time: the file holds a whole layout that is feasible, or there is none."""
    problem = instance(random.Random(5))
    path, out = os.path.join(folder, "problem.json"), os.path.join(folder, "killed.json")
    with open(path, "w", encoding="utf-8") as file:
        json.dump(nesting_json(problem), file)
    whole = 0
    for k in range(count):
        with subprocess.Popen([program, "pack", path, *wishes(problem), "--seed", str(k), "-o", out, "-q"],
                              stdout=subprocess.DEVNULL) as search:
            if k % 2:  # from the first layout on
                while search.poll() is None and not os.path.exists(out):
                    time.sleep(0.001)
            time.sleep(rng.uniform(0, 0.2))
            search.kill()
        if not os.path.exists(out):
            continue
        with open(out, encoding="utf-8") as file:
            wrong = faults(problem, json.load(file)["layout"])
        if wrong:
            fail(5, f"killed: {'; '.join(wrong)}")
        os.remove(out)
        whole += 1
    if whole < count // 2:
        fail(5, f"{whole} files of {count} killed searches")
    print(f"{whole} of {count} killed searches left a layout, whole and feasible; the others no file")


def check_refusals(program, folder):
    """Wrong and empty problems: the status, the words, and no file where nothing was packed."""
    path, out = os.path.join(folder, "wrong.json"), os.path.join(folder, "wrong.layout.json")
    for problem, status, words in REFUSALS:
        with open(path, "w", encoding="utf-8") as file:
            json.dump(problem, file)
        done = run(program, "pack", path, "--work", "1", "--threads", "1", "-o", out)
        if done.returncode != status or words not in done.stdout + done.stderr:
            fail(0, f"{problem}: status {done.returncode}, {done.stdout}{done.stderr}")
        if status == 3 and os.path.exists(out):
            fail(0, f"{problem}: a file was written")
        if os.path.exists(out):
            os.remove(out)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("executable")
    parser.add_argument("--count", type=int, default=40)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--kills", type=int, default=0)
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        check_refusals(arguments.executable, folder)
        check_interrupt(arguments.executable, folder)
        check_kills(arguments.executable, folder, arguments.kills, random.Random(arguments.seed))
        for k in range(arguments.count):
            check_instance(arguments.executable, arguments.seed * 100000 + k, folder)
    print(f"{arguments.count} layouts are feasible, and verify agrees on {3 * arguments.count} others")


if __name__ == "__main__":
    main()
