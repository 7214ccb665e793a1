#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Two ranks against one, memory over ranks and resolutions, and the unit times that tools/simulate_ranks.py takes.

usage: ranks.py PROGRAM PROGRAM_MPI [--triangles N] [--resolution N] [--jobs N] [--units FILE] [--memory] [--store]

The maps are of a wavy torus, the batch mixes all verbs. Seconds by the clock stand beside processor seconds of all ranks. A rank
that waits asks for messages all the time, so processor time holds the waiting as well: one rank's over two ranks' is an efficiency that
other programs on the machine do not change."""
import argparse
import json
import math
import os
import random
import re
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
EXAMPLES = ROOT / "examples"
MPI = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1", OMPI_MCA_rmaps_base_oversubscribe="1",
           OMPI_MCA_hwloc_base_binding_policy="none", OMPI_MCA_btl_vader_single_copy_mechanism="none")
RANK_MEMORY = "import resource,subprocess,sys\ns=subprocess.call(sys.argv[2:])\n" \
              "open(sys.argv[1],'a').write(str(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)+'\\n')\nsys.exit(s)"


def wavy_torus(path, triangles):
    """Nearly so many triangles."""
    around = max(4, round(math.sqrt(triangles * 5 / 2)))
    about = max(4, round(triangles / 2 / around))
    lines = []
    for i in range(around):
        for j in range(about):
            u, v = 2 * math.pi * i / around, 2 * math.pi * j / about
            r = 3 + 0.4 * math.sin(7 * u) * math.cos(3 * v)
            lines.append(f"v {(10 + r * math.cos(v)) * math.cos(u):.4f} {(10 + r * math.cos(v)) * math.sin(u):.4f} {r * math.sin(v):.4f}")
    for i in range(around):
        for j in range(about):
            a, b = i * about + j, i * about + (j + 1) % about
            c, d = (i + 1) % around * about + j, (i + 1) % around * about + (j + 1) % about
            lines.append(f"f {a + 1} {c + 1} {d + 1}\nf {a + 1} {d + 1} {b + 1}")
    Path(path).write_text("\n".join(lines) + "\n")
    return 2 * around * about


def mesh_scenes(folder, triangles):
    """Where a ball meets the torus, and where a box keeps a clearance to it, which costs a hundred times as much."""
    count = wavy_torus(folder / "torus.obj", triangles)
    torus = {"file": "torus.obj"}
    ball, box = {"ball": {"center": [0, 0, 0], "radius": 1}}, {"box": {"min": [-0.5, -0.4, -0.3], "max": [0.5, 0.4, 0.3]}}
    for name, tool, where in (("mesh", ball, "gap(tool, torus) <= 0"), ("level", box, "gap(tool, torus) <= 0.1")):
        scene = {"findspace": 1, "grid": 0.0001, "shapes": {"torus": torus, "tool": tool}, "moving": "tool", "where": where}
        (folder / f"{name}.json").write_text(json.dumps(scene))
    return count


def star(rng, corners, radius):
    turn = rng.uniform(0, 1)
    return [[round(radius * (1 if k % 2 else 0.6) * math.cos(2 * math.pi * (k + turn) / corners), 3),
             round(radius * (1 if k % 2 else 0.6) * math.sin(2 * math.pi * (k + turn) / corners), 3)] for k in range(corners)]


def plane_scene(rng, obstacles):
    shapes = {"sheet": {"box": {"min": [0, 0], "max": [200, 200]}}, "part": {"polygon": star(rng, 24, 9)}}
    ring = star(rng, 40, 14)
    shapes["holes"] = {"union": [{"translate": [round(rng.uniform(10, 190), 2), round(rng.uniform(10, 190), 2)], "of": {"polygon": ring}} for _ in range(obstacles)]}
    return {"findspace": 1, "grid": 0.0001, "shapes": shapes, "moving": "part", "where": "inside(part, sheet) and clear(part, holes)"}


def space_scene(rng, corners=16):
    def points():
        return [[rng.randint(-20, 20) for _ in range(3)] for _ in range(corners)]
    return {"findspace": 1, "shapes": {"a": {"polytope": points()}, "b": {"polytope": points()}}, "moving": "b", "where": "gap(b, a) <= 1"}


def problem(rng):
    parts = [{"name": f"p{k}", "demand": rng.randint(1, 4), "shape": star(rng, 10, rng.uniform(3, 8))} for k in range(4)]
    return {"findspace": 1, "strip_height": 40, "parts": parts}


def mixed_jobs(folder, count, seed=1):
    """Of all verbs, over some scenes that many of them share."""
    rng = random.Random(seed)
    for k in range(12):
        (folder / f"plane{k}.json").write_text(json.dumps(plane_scene(rng, rng.randint(4, 24))))
        (folder / f"space{k}.json").write_text(json.dumps(space_scene(rng)))
    lines = []
    for k in range(count):
        verb = rng.choices(["map", "check", "measure", "explain", "describe", "phi", "place", "pack", "lines"], [25, 27, 15, 1, 7, 10, 3, 2, 10])[0]
        plane, space = f"plane{rng.randrange(12)}.json", f"space{rng.randrange(12)}.json"
        at = [round(rng.uniform(0, 200), 2), round(rng.uniform(0, 200), 2)]
        job = {"id": k, "verb": verb, "path": plane}
        if verb in ("check", "measure"):
            job["options"] = {"at": at}
        elif verb == "describe":
            job["shapes"] = ["holes"]
        elif verb == "phi":
            job.update(path=space, shapes=["a", "b"], options={"at": [rng.randint(-30, 30) for _ in range(3)]})
        elif verb == "place":
            job["path"] = str(EXAMPLES / "components.json")
        elif verb == "pack":
            job.update(path=str(EXAMPLES / "packing" / "hide.json"), options={"work": 2, "seed": rng.randrange(4)})
        elif verb == "lines":
            job.update(verb="map", path=space, options={"resolution": 48})
        lines.append(json.dumps(job))
    (folder / "jobs.jsonl").write_text("\n".join(lines) + "\n")


class Timed:
    """The least seconds by the clock and of the processor, of all processes that the command starts; `repeat` runs."""

    def __init__(self, command, folder, repeat=1, before_each=lambda: None):
        self.clock = self.processor = math.inf
        for _ in range(repeat):
            before_each()
            before, begun = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
            self.run = subprocess.run(command, cwd=folder, env=MPI, capture_output=True, text=True)
            after = resource.getrusage(resource.RUSAGE_CHILDREN)
            self.clock = min(self.clock, time.monotonic() - begun)
            self.processor = min(self.processor, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)
            if self.run.returncode not in (0, 1):
                sys.exit(f"{' '.join(map(str, command))}: {self.run.stderr}")


def ranked(count, program, *arguments):
    return ["mpirun", "-n", str(count), program, *map(str, arguments)]


def account_of(text):
    found = re.search(r"rank 0 made (\d+) rows in ([\d.]+) s \(slowest ([\d.]+) s a row\), took (\d+) rows in ([\d.]+) s, waited ([\d.]+) s", text)
    return [float(x) for x in found.groups()]


def compare(name, one, two):
    print(f"| {name} | {one.clock:.2f} | {two.clock:.2f} | {one.clock / two.clock / 2:.3f} | {one.processor:.2f} | {two.processor:.2f} | {one.processor / two.processor:.3f} |", flush=True)


def map_units(options, folder, name, resolution, rows):
    """Of the map on resolution² lines; the costs of its rows are those of a map on rows² lines."""
    def command(n):
        return ["map", f"{name}.json", "--resolution", n, "-o", "map.json"]
    few = Timed(ranked(1, options.program_mpi, *command(8)), folder, options.repeat)
    runs = {n: Timed(ranked(n, options.program_mpi, *command(resolution)), folder, options.repeat) for n in (1, 2)}
    compare(f"map '{name}' of a mesh of {options.triangles} triangles, {resolution}² lines", runs[1], runs[2])
    made, making, slowest, taken, taking, _ = account_of(runs[2].run.stderr)
    longer = rows / resolution  # a row
    per_row = (runs[1].processor - few.processor - taking) / taken
    size = (folder / "map.json").stat().st_size
    spread = slowest * made / making
    return {"rows": rows, "triangles": options.triangles, "row_samples": row_samples(per_row * longer, per_row * longer * spread, 256),
            "take_seconds": taking / taken * longer * 0.7, "read_seconds": taking / taken * longer * 0.3, "row_bytes": size / taken * longer,
            "scene_bytes": (folder / "torus.obj").stat().st_size, "start_seconds": few.processor, "end_seconds": 0.0, "processor": {str(n): run.processor for n, run in runs.items()},
            "measured": {str(n): run.clock for n, run in runs.items()} if longer == 1 else {}}


def row_samples(mean, slowest, rows):
    """Costs of rows, evenly spread about the mean up to the slowest that was measured, and down as far."""
    low = max(2 * mean - slowest, 0)
    spread = [low + (slowest - low) * (0.5 - 0.5 * math.cos(2 * math.pi * j / rows)) for j in range(rows)]
    total = sum(spread)
    return [round(c * mean * rows / total, 9) for c in spread]


def batch_units(options, folder):
    mixed_jobs(folder, options.jobs)
    runs = {n: Timed(ranked(n, options.program_mpi, "batch", "jobs.jsonl", "-o", f"r{n}.jsonl"), folder, options.repeat) for n in (1, 2)}
    compare(f"batch of {options.jobs} mixed questions", runs[1], runs[2])
    results = [json.loads(line) for line in (folder / "r1.jsonl").read_text().splitlines()]
    ends = {r["status"] for r in results}
    if not ends <= {"done", "empty"}:
        sys.exit(f"not all are answered: {ends}: {[r for r in results if r['status'] not in ('done', 'empty')][:2]}")
    seconds = [r["seconds"] for r in results]
    empty = folder / "one.jsonl"
    empty.write_text((folder / "jobs.jsonl").read_text().splitlines()[0] + "\n")
    start = Timed(ranked(1, options.program_mpi, "batch", "one.jsonl", "-o", "r.jsonl"), folder)
    alone = max(runs[1].clock - start.clock - sum(seconds), 0) / len(seconds)
    return {"job_seconds": seconds, "start_seconds": start.clock, "job_overhead": alone, "end_seconds_a_job": 2e-5,
            "measured": {str(n): run.clock for n, run in runs.items()}, "processor": {str(n): run.processor for n, run in runs.items()}}


def memory_table(options, folder):
    mesh_scenes(folder, options.triangles)
    resolutions = [512, 1024, 2048, 4096]
    print("\n| ranks | " + " | ".join(f"{n}² lines: rank 0, largest other, MB" for n in resolutions) + " |\n|---|" + "---|" * len(resolutions))
    for count in (1, 2, 3, 4):
        cells = []
        for n in resolutions:
            (folder / "memory").unlink(missing_ok=True)
            wrapped = ["mpirun", "-n", "1", sys.executable, "-c", RANK_MEMORY, "memory0"] + [options.program_mpi, "map", "mesh.json", "--resolution", str(n), "-o", "map.json"]
            if count > 1:
                wrapped += [":", "-n", str(count - 1), sys.executable, "-c", RANK_MEMORY, "memory"] + [options.program_mpi, "map", "mesh.json", "--resolution", str(n), "-o", "map.json"]
            (folder / "memory0").unlink(missing_ok=True)
            Timed(wrapped, folder)
            first = int((folder / "memory0").read_text()) / 1024
            others = [int(x) / 1024 for x in (folder / "memory").read_text().split()] if count > 1 else []
            cells.append(f"{first:.0f}" + (f", {max(others):.0f}" if others else ""))
        print(f"| {count} | " + " | ".join(cells) + " |", flush=True)


def rough_parts(folder, corners):
    """Eight outlines as a scanner gives them."""
    rng = random.Random(3)
    items = []
    for k in range(8):
        size, a, b, c = rng.uniform(20, 40), rng.uniform(0, 7), rng.uniform(0, 7), rng.uniform(0, 7)
        ring = []
        for j in range(corners):
            t = 2 * math.pi * j / corners
            r = size * (1 + 0.25 * math.sin(3 * t + a) + 0.15 * math.sin(7 * t + b) + 0.03 * math.sin(40 * t + c))
            ring.append([round(r * math.cos(t), 3), round(r * math.sin(t), 3)])
        items.append({"id": k, "demand": 2, "allowed_orientations": [0.0, 90.0, 180.0, 270.0], "shape": {"type": "simple_polygon", "data": ring}})
    path = folder / f"rough{corners}.json"
    path.write_text(json.dumps({"name": path.stem, "strip_height": 200, "items": items}))
    return path


def store_gain(options, folder):
    """The same nesting problem with eight seeds: by programs of their own, in a batch, and in one whose store is full."""
    problems = [(options.nesting / "swim.json", "0"), (rough_parts(folder, 100), "0"), (rough_parts(folder, 100), "1"), (rough_parts(folder, 300), "0"),
                (rough_parts(folder, 300), "1")]
    print("| problem | gap | own programs, processor s | batch | gain | batch, store full | gain |\n|---|---|---|---|---|---|---|")
    for path, gap in problems:
        seeds = range(1, 9)
        script = "\n".join(f"{options.program} pack {path} --work 0.1 --threads 1 --gap {gap} --seed {seed} -q --json > /dev/null" for seed in seeds)
        lines = [json.dumps({"verb": "pack", "path": str(path), "options": {"work": 0.1, "threads": 1, "gap": gap, "seed": seed}}) for seed in seeds]
        (folder / "nest.jsonl").write_text("\n".join(lines) + "\n")
        batch = [options.program, "batch", "nest.jsonl", "-o", "n.jsonl", "--workers", "1"]
        own, fresh = Timed(["sh", "-c", script], folder, options.repeat), Timed(batch, folder, options.repeat)
        Timed([*batch, "--store", "kept"], folder)
        full = Timed([*batch, "--store", "kept"], folder, options.repeat)
        print(f"| {path.stem} | {gap} | {own.processor:.2f} | {fresh.processor:.2f} | {own.processor / fresh.processor:.2f} | {full.processor:.2f} | "
              f"{own.processor / full.processor:.2f} |", flush=True)


def main(argv):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=os.path.abspath)
    parser.add_argument("program_mpi", type=os.path.abspath)
    parser.add_argument("--triangles", type=int, default=100000)
    parser.add_argument("--resolution", type=int, default=2048)
    parser.add_argument("--jobs", type=int, default=2000)
    parser.add_argument("--repeat", type=int, default=3, help="runs of each, of which the fastest counts (default 3)")
    parser.add_argument("--units", help="write the unit times there")
    parser.add_argument("--memory", action="store_true", help="the table of memory alone")
    parser.add_argument("--store", action="store_true", help="the gain of the store alone")
    parser.add_argument("--nesting", type=Path, default=ROOT / "tests" / "data" / "nesting")
    options = parser.parse_args(argv)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        if options.memory:
            return memory_table(options, folder)
        if options.store:
            return store_gain(options, folder)
        print("| job | 1 rank, s | 2 ranks, s | efficiency | 1 rank, processor s | 2 ranks, processor s | efficiency by processor |\n|---|---|---|---|---|---|---|")
        mesh_scenes(folder, options.triangles)
        units = {"map": map_units(options, folder, "mesh", options.resolution, options.resolution),
                 "level": map_units(options, folder, "level", options.resolution, options.resolution), "batch": batch_units(options, folder)}
        if options.units:
            Path(options.units).write_text(json.dumps(units) + "\n")


if __name__ == "__main__":
    main(sys.argv[1:])
