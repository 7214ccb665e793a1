#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Runs acceptance cases against the findspace executable and prints what differs.

usage: run_cases.py EXECUTABLE [CASE_OR_FOLDER ...] [--only REGEX] [--scope FILE] [--only-distances NAME,...]
                    [--list] [--quiet]

A case is a JSON file `*.case.json`; tests/cases/README.md says what its keys mean. Without a place, tests/cases runs,
subfolders included.

  --only REGEX           the cases whose id the expression finds
  --scope FILE           only what the program is meant to do so far (tests/cases/scope.json): cases beyond it are
                         counted apart, and of a `measure` only the distances in scope are compared
  --only-distances LIST  the same with just a list of distances, e.g. gamma1,eta1,d1
  --list                 prints which cases are in scope and why others are not, and runs none
  --quiet                prints the count alone

The last line is 'N passed, N failed'. Exit status 0 when every case holds, 1 when one fails, 2 for wrong usage."""
import argparse
import json
import os
import re
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
SECONDS = int(os.environ.get("CASE_SECONDS", "120"))  # for an answer; sanitized programs take longer
CASES = os.path.join(ROOT, "tests", "cases")
DISTANCES = {"gamma1", "gamma2", "eta1", "eta2", "delta1", "delta2", "mu", "hausdorff", "d1", "d2", "dstar", "h",
             "diameter", "penetration"}
STANDS_FOR = {"overlaps": "gamma1", "touches": "gamma1", "disjoint": "gamma1", "clear": "gamma1", "within": "gamma1",
              "near": "gamma1", "far": "gamma1", "keepout": "gamma1", "group": "diameter", "gap": "gamma1", "inside": "eta1", "margin": "eta1", "covers": "delta1", "reach": "gamma2",
              "distance": "d1"}
EXPECTED = {"attained", "distances", "encloses", "exit", "intervals", "phi", "positions", "region", "regions", "says", "true"}
SOLIDS = {"polytope", "ball", "prism", "height_field", "mesh"}


# --- what the program is meant to do so far ------------------------------------------------------------------------

class Scope:
    """The verbs, carriers, distances and dimensions in scope; None stands for all of them."""

    def __init__(self, verbs=None, carriers=None, distances=None, dimensions=None, not_yet=None):
        self.verbs, self.carriers, self.distances = verbs, carriers, distances
        self.dimensions, self.not_yet = dimensions, not_yet or {}

    @staticmethod
    def read(path):
        with open(path, encoding="utf-8") as file:
            return Scope(**{k: v for k, v in json.load(file).items() if k != "about"})

    def beyond(self, case):
        """Why the case is beyond the scope, or None where it is not."""
        scene, want = case.get("scene", {}), case["expect"]
        if case["id"] in self.not_yet:
            return self.not_yet[case["id"]]
        if self.verbs is not None and case["run"][0] not in self.verbs:
            return f"verb {case['run'][0]}"
        if self.dimensions is not None and dimension(scene) not in self.dimensions:
            return f"dimension {dimension(scene)}"
        if self.carriers is not None and carrier(scene) not in self.carriers:
            return f"carrier {carrier(scene)}"
        if self.distances is None:
            return None
        strange = distances_of(scene) - set(self.distances)
        if strange:
            return "distance " + ", ".join(sorted(strange))
        keys = want.get("distances", {})
        return "distance " + ", ".join(sorted({base(k) for k in keys})) if keys and not self.wanted(keys) else None

    def wanted(self, distances):
        """Of expected distances those in scope."""
        return {k: v for k, v in distances.items() if self.distances is None or base(k) in self.distances}


def base(key):
    """The distance a canonical text names; one with a direction, a turn or a time is a distance of its own."""
    name = key.split("(")[0].strip()
    for word, known in (("along", "along"), ("toward", "toward"), ("rotating", "turning"), ("turning", "turning")):
        if word + "=" in key.replace(" ", ""):
            return f"{name} {known}"
    return name


def distances_of(scene):
    """The distances a scene's formula and goals use, predicates and sugar resolved."""
    text = " ".join(str(scene.get(k, "")) for k in ("where", "minimize", "maximize", "place"))
    names = "|".join(sorted(DISTANCES | STANDS_FOR.keys()))
    uses = re.findall(rf"\b({names})\s*\(([^()]*(?:\([^()]*\)[^()]*)*)\)", text)
    return {base(f"{STANDS_FOR.get(name, name)}({arguments})") for name, arguments in uses}


def dimension(scene):
    """3 where a scene holds a solid or a point of three coordinates."""
    def solid(node):
        if isinstance(node, dict):
            return bool(SOLIDS & node.keys()) or any(solid(n) for n in node.values())
        if isinstance(node, list):
            return len(node) == 3 and all(isinstance(n, (int, float)) for n in node) or any(solid(n) for n in node)
        return isinstance(node, str) and node.lower().endswith((".stl", ".obj", ".off", ".ply", ".3mf", ".glb", ".asc", ".step", ".stp", ".iges", ".igs"))
    return 3 if solid(scene.get("shapes")) else 2


def carrier(scene):
    if "motion" in scene:
        return "motion"
    free = scene.get("free", "position")
    return free if isinstance(free, str) else next(iter(free))


# --- one case ------------------------------------------------------------------------------------------------------

def call(exe, case, arguments):
    """Runs one verb over the case's scene: exit status, the JSON result or None, what it said."""
    text = case["scene_text"] if "scene_text" in case else json.dumps(case["scene"])
    with tempfile.TemporaryDirectory() as folder:
        scene = os.path.join(folder, os.path.basename(case.get("scene_file", "scene.json")))
        with open(scene, "w", encoding="utf-8") as file:
            file.write(text)
        for name, content in case.get("files", {}).items():
            with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
                file.write(content)
        done = subprocess.run([exe, arguments[0], scene, *arguments[1:], "--json"], capture_output=True, text=True,
                              timeout=SECONDS)
    try:
        result = json.loads(done.stdout) if done.stdout.strip() else None
    except json.JSONDecodeError:
        result = None
    return done.returncode, result, done.stderr


def nothing_said(status, said):
    """A run without a result; a negative status is the signal that ended it."""
    return f"no JSON result, exit status {status}: {said.strip()[:200]}"


def close(got, want, tolerance):
    if got is None or want is None or isinstance(got, str) or isinstance(want, str):
        return got == want
    return abs(got - want) <= tolerance * max(1.0, abs(got), abs(want)) * 10


def close_point(got, want, tolerance):
    return len(got) == len(want) and all(close(a, b, tolerance) for a, b in zip(got, want))


def same_points(got, want, tolerance):
    left = list(got or [])
    for point in want:
        hit = next((p for p in left if close_point(p, point, tolerance)), None)
        if hit is None:
            return False
        left.remove(hit)
    return not left


def text_of(position):
    return ",".join(str(int(c)) if c == int(c) else repr(float(c)) for c in position)


def region_faults(exe, case, got, want, shape=None):
    """What differs between a region of the result and the expected one, as 'key: expected .., got ..'."""
    where = f"{shape} " if shape else ""
    tolerance = max(case.get("tolerance", 1e-9), 1e-9)
    components = got.get("components") or []
    for key, value in want.items():
        found = got.get(key)
        if key in ("area", "volume", "dangling_length", "crack_length", "minimum"):
            framed = key in ("area", "volume") and found is None and "frame" in want
            good = framed or got.get("empty") and value == 0 or close(found, value, tolerance)
        elif key in ("open", "closed", "empty", "whole", "holes"):
            good = found == value
        elif key == "components":
            found = len(components)
            good = found == value
        elif key == "by_dimension":
            found = {d: sum(1 for c in components if str(c["dimension"]) == d) for d in value}
            good = found == {d: int(n) for d, n in value.items()}
        elif key == "isolated":
            good = same_points(found, value, tolerance)
        elif key == "probes":
            yield from probe_faults(exe, case, value) if shape is None else ()
            good = True
        else:
            found, good = "a key this runner does not know", key == "frame"
        if not good:
            yield f"{where}{key}: expected {value}, got {found}"


def probe_faults(exe, case, probes):
    for position, belongs in probes:
        status, result, said = call(exe, case, ["check", "--at", text_of(position)])
        if result is None:
            yield f"probe {position}: {nothing_said(status, said)}"
            continue
        found = result.get("true")
        if found != belongs:
            yield f"probe {position}: expected {belongs}, got {found}"


def enclosure_faults(case, got, want):
    """Value and bound of an extremum enclose the truth, and are as near to each other as they should be."""
    truth, gap = want
    turn, value = (1, got.get("minimum")) if "minimum" in got else (-1, got.get("maximum"))
    bound = got.get("bound", value)
    numbers = all(isinstance(n, (int, float)) for n in (value, bound))
    room = case.get("tolerance", 1e-9)
    if not numbers or turn * bound > turn * truth + room or turn * value < turn * truth - room or abs(value - bound) > gap:
        yield f"encloses: expected {truth} between bounds {gap} apart, got {value} and {bound}"


def interval_faults(case, got, want):
    tolerance = case.get("tolerance", 1e-9)
    same = len(got) == len(want) and all(
        close(g["from"], w[0], tolerance) and close(g["to"], w[1], tolerance) and [g["from_in"], g["to_in"]] == w[2:]
        for g, w in zip(got, want))
    if not same:
        yield f"intervals: expected {want}, got {got}"


def position_faults(case, got, want):
    tolerance = case.get("tolerance", 1e-9)
    places = [p.get("at") for p in got]
    same = len(places) == len(want) and all(
        (g is None) == (w is None) and (g is None or close_point(g, w, tolerance)) for g, w in zip(places, want))
    if not same:
        yield f"positions: expected {want}, got {places}"


def phi_faults(exe, case, got, want):
    facets = got.get("facets", [])
    found = {"facets": len(facets), "vertex_count": len(got.get("vertices", [])),
             "planes": sorted(f["plane"] for f in facets),
             "contact_counts": {k: sum(1 for f in facets if f.get("contact") == k)
                                for k in want.get("contact_counts", {})}}
    for key in found.keys() & want.keys():
        value = sorted(want[key]) if key == "planes" else want[key]
        if found[key] != value:
            yield f"{key}: expected {value}, got {found[key]}"
    for query in want.get("queries", []):
        status, result, said = call(exe, case, [*case["run"], "--at", text_of(query["at"])])
        if result is None:
            yield f"at {query['at']}: {nothing_said(status, said)}"
            continue
        at = result.get("at", {})
        # A contact can be demanded only where the position is one the scene's numbers express exactly.
        exact = all(float(c) * 64 == int(float(c) * 64) for c in query["at"])
        if "state" in query and (exact or query["state"] != "contact") and at.get("state") != query["state"]:
            yield f"at {query['at']} state: expected {query['state']}, got {at.get('state')}"
        for key in ("phi", "distance"):
            if key in query and not close(at.get(key), query[key], 1e-8):
                yield f"at {query['at']} {key}: expected {query[key]}, got {at.get(key)}"


def refusal_faults(want, status, said):
    if status != want["exit"]:
        yield f"exit status: expected {want['exit']}, got {status}"
    if status and not said.strip():
        yield "no message on standard error"
    says = want.get("says", [])
    for pattern in [says] if isinstance(says, str) else says:
        if not re.search(pattern, said, re.I):
            yield f"the message lacks '{pattern}': {said.strip()[:200]}"


def faults(exe, case, scope):
    want = case["expect"]
    if not want or want.keys() - EXPECTED:
        yield f"expect: {', '.join(sorted(want.keys() - EXPECTED)) or 'nothing'} is no key that this runner knows"
    if set(want) == {"phi"} and set(want["phi"]) == {"queries"}:
        yield from phi_faults(exe, case, {}, want["phi"])
        return
    status, got, said = call(exe, case, case["run"])
    if "exit" in want:
        yield from refusal_faults(want, status, said)
        if not want.keys() - {"exit", "says"}:
            return
    if got is None:
        yield nothing_said(status, said)
        return
    if "exit" not in want and status not in ((0, 1, 4) if "encloses" in want else (0, 1)):
        yield f"exit status {status}: {said.strip()[:200]}"
    yield from region_faults(exe, case, got, want.get("region", {}))
    for name, value in scope.wanted(want.get("distances", {})).items():
        found = got.get("distances", {}).get(name, "missing")
        if found == "missing" or not close(found, value, case.get("tolerance", 1e-9)):
            yield f"{name}: expected {value}, got {found}"
    if "encloses" in want:
        yield from enclosure_faults(case, got, want["encloses"])
    if "intervals" in want:
        yield from interval_faults(case, got.get("intervals", []), want["intervals"])
    if "positions" in want:
        yield from position_faults(case, got.get("positions", []), want["positions"])
    for key in ("attained", "true"):
        if key in want and got.get(key) != want[key]:
            yield f"{key}: expected {want[key]}, got {got.get(key)}"
    for name, region in want.get("regions", {}).items():
        yield from region_faults(exe, case, got.get("regions", {}).get(name, {}), region, shape=name)
    yield from phi_faults(exe, case, got, want.get("phi", {}))


def faults_of(exe, case, scope):
    try:
        return list(faults(exe, case, scope))
    except subprocess.TimeoutExpired:
        return [f"no answer in {SECONDS} s"]
    except (KeyError, TypeError, ValueError, AttributeError, IndexError) as error:
        return [f"the result has an unexpected form: {type(error).__name__}: {error}"]


# --- all of them ---------------------------------------------------------------------------------------------------

def case_files(places):
    for place in places:
        if not os.path.isdir(place):
            yield place
            continue
        for folder, folders, names in os.walk(place):
            folders.sort()
            yield from (os.path.join(folder, n) for n in sorted(names) if n.endswith(".case.json"))


def cases(places, only):
    for path in case_files(places):
        with open(path, encoding="utf-8") as file:
            case = json.load(file)
        if "scene_file" in case:
            with open(os.path.join(ROOT, case["scene_file"]), encoding="utf-8") as file:
                case["scene_text"] = file.read()
            if case["scene_file"].endswith(".json"):
                case["scene"] = json.loads(re.sub(r"^\s*//.*$", "", case["scene_text"], flags=re.M))
            else:
                case["scene"] = {"unit": "mm"}  # of a board
        if not only or re.search(only, case["id"]):
            yield case


def main(argv):
    parser = argparse.ArgumentParser(usage=__doc__.split("\n\n")[1].removeprefix("usage: "))
    parser.add_argument("executable")
    parser.add_argument("places", nargs="*", default=[CASES])
    parser.add_argument("--only")
    parser.add_argument("--scope")
    parser.add_argument("--only-distances")
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--quiet", action="store_true")
    options = parser.parse_intermixed_args(argv)
    scope = Scope.read(options.scope) if options.scope else Scope()
    if options.only_distances:
        scope.distances = options.only_distances.split(",")

    exe = os.path.abspath(options.executable)
    passed = failed = beyond = 0
    for case in cases(options.places, options.only):
        reason = scope.beyond(case)
        if options.list:
            print(case["id"], "in scope" if not reason else f"beyond: {reason}")
        if reason:
            beyond += 1
            continue
        found = [] if options.list else faults_of(exe, case, scope)
        passed, failed = passed + (not found), failed + bool(found)
        if found and not options.quiet:
            print(f"{case['id']}: " + "; ".join(found)[:600])
    if beyond:
        print(f"{beyond} beyond the scope so far")
    print(f"{passed} in scope" if options.list else f"{passed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
