#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Heights of `findspace pack` on the data sets of solids, beside those of sparrow-3d, as a table in Markdown.

usage: packing_solids.py EXECUTABLE [--data FOLDER] [--seconds S | --work N] [--seeds N] [--threads N] [--runs FILE] [INSTANCE...]
       packing_solids.py EXECUTABLE [--data FOLDER] [--seconds S] --mixed N    N parts of all sets in boxes

FOLDER holds stoyan2004, stoyan2005, egeblad2009 and liu2015 (default: ../shared/data/3d beside the repository). An
INSTANCE "by faces" has meshes without the vertices that no face uses: sparrow-3d drops these when it reads a file,
where findspace takes the hull of all vertices of a convex mesh (polytope7 of 2005: a volume of 192.5, not 174.5). The
figures of sparrow-3d are the mean and the best of 15 seeds of ten minutes with 4 workers. "processor" is the time that
the machine gave the program in the mean: other work on the machine takes from it. "first" is the time of the first
layout. Evaluations are boxes and planes looked at, of one island, where --work limits them. FILE keeps each run by the
clock as a line of JSON, and what stands there is not run again, so a table may take several days."""
import argparse
import glob
import json
import os
import re
import resource
import subprocess
import sys
import tempfile

from kept_runs import add_runs, kept_runs

HERE = os.path.dirname(os.path.abspath(__file__))
SPARROW = {"stoyan2004/Example1": (51.54, 50.37), "stoyan2004/Example2": (29.00, 29.00),
           "stoyan2004/Example3": (40.07, 38.67), "stoyan2004/Example4": (54.21, 52.00),
           "stoyan2004/Example5": (68.02, 65.10), "stoyan2005/Example1 by faces": (17.46, 17.46),
           "stoyan2005/Example2 by faces": (19.00, 19.00), "stoyan2005/Example3 by faces": (27.52, 26.87),
           "egeblad2009/Merged1": (16.55, 16.16), "egeblad2009/Merged2": (20.97, 20.38),
           "egeblad2009/Merged3": (22.00, 22.00), "egeblad2009/Merged4": (23.84, 23.01),
           "egeblad2009/Merged5": (26.14, 24.64), "liu2015/Experiment1": (30.55, 30.15)}
BY_FACES = " by faces"
NOTE = re.compile(r"([\d.]+) s +processor +([\d.]+) s +height ([\d.]+)")


def one_run(arguments, name, seed):
    """As run_of() has it."""
    if not name.endswith(BY_FACES):
        return run_of(arguments, os.path.join(arguments.data, name + ".json"), seed)
    with tempfile.TemporaryDirectory() as folder:
        return run_of(arguments, by_faces(os.path.join(arguments.data, name.removesuffix(BY_FACES) + ".json"), folder), seed)


def by_faces(problem, folder):
    """Writes the problem and its OBJ files without vertices that no face uses, and tells the name."""
    with open(problem, encoding="utf-8") as file:
        read = json.load(file)
    for item in read["item-types"]:
        with open(mesh_of(os.path.dirname(problem), item["path"]), encoding="utf-8") as file:
            lines = [line.split("#")[0].split() for line in file]
        item["path"] = os.path.basename(item["path"])
        with open(os.path.join(folder, item["path"]), "w", encoding="utf-8") as file:
            file.write(used_vertices_and_faces(lines))
    name = os.path.join(folder, os.path.basename(problem))
    with open(name, "w", encoding="utf-8") as file:
        json.dump(read, file)
    return name


def used_vertices_and_faces(lines):
    """The text of an OBJ file, of its lines as words."""
    faces = [[int(word.split("/")[0]) for word in line[1:]] for line in lines if line[:1] == ["f"]]
    vertices = [" ".join(line) for line in lines if line[:1] == ["v"]]
    used = sorted({vertex for face in faces for vertex in face})
    number = {vertex: k for k, vertex in enumerate(used, 1)}
    return "\n".join([vertices[vertex - 1] for vertex in used] +
                     [" ".join(["f", *(str(number[vertex]) for vertex in face)]) for face in faces]) + "\n"


def run_of(arguments, problem, seed):
    """The curve, (seconds, processor seconds, height) of every better layout, the processor time and the lower bound."""
    limit = ["--work", str(arguments.work)] if arguments.work else ["--time-limit", str(arguments.seconds)]
    before = os.times()
    done = subprocess.run([arguments.executable, "pack", problem, *limit, "--threads", str(arguments.threads), "--seed",
                           str(seed)], capture_output=True, text=True, check=False)
    after = os.times()
    if done.returncode != 0:
        sys.exit(done.stderr)
    points = [(float(s), float(p), float(h)) for s, p, h in NOTE.findall(done.stderr)]
    bound = re.search(r"no layout is lower(?: than ([\d.]+))?", done.stdout).group(1)
    return {"curve": points, "processor": after.children_user - before.children_user, "bound": bound or "reached"}


def runs_of(arguments, name):
    if not arguments.runs:
        return [one_run(arguments, name, seed) for seed in range(1, arguments.seeds + 1)]
    return [line for line in kept_runs(arguments.runs, arguments.seconds) if line["instance"] == name]


def mesh_of(folder, path):
    """Where the file of an item lies, whose path begins with the folder of another machine."""
    parts = path.replace("\\", "/").split("/")
    found = glob.glob(os.path.join(folder, "**", *parts[-2:]), recursive=True)
    return (found or glob.glob(os.path.join(folder, "**", parts[-1]), recursive=True))[0]


def mixed_problem(arguments):
    """Equally many of every item of all sets, in boxes of 60."""
    meshes = []
    for name in SPARROW:
        folder = os.path.join(arguments.data, os.path.dirname(name))
        with open(os.path.join(arguments.data, name.removesuffix(BY_FACES) + ".json"), encoding="utf-8") as file:
            meshes += [mesh_of(folder, item["path"]) for item in json.load(file)["item-types"]]
    meshes = list(dict.fromkeys(os.path.abspath(mesh) for mesh in meshes))
    items = [{"id": str(k), "path": mesh, "demand": arguments.mixed // len(meshes) + (k < arguments.mixed % len(meshes))}
             for k, mesh in enumerate(meshes)]
    box = {"id": "box", "count": arguments.mixed, "size-x": 60, "size-y": 60, "size-z": 60}
    return len(meshes), {"name": "mixed", "containers": [box], "item-types": items}


def mixed_table(arguments):
    kinds, problem = mixed_problem(arguments)
    with tempfile.NamedTemporaryFile("w", suffix=".json", encoding="utf-8") as file:
        json.dump(problem, file)
        file.flush()
        done = subprocess.run([arguments.executable, "pack", file.name, "--time-limit", str(arguments.seconds), "--threads",
                               str(arguments.threads)], capture_output=True, text=True, check=False)
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode != 0:
        sys.exit(done.stderr)
    first, last = NOTE.findall(done.stderr)[0], NOTE.findall(done.stderr)[-1]
    print(f"{arguments.mixed} parts of {kinds} kinds; first layout after {first[0]} s ({first[1]} s of the processor), last "
          f"gain after {last[0]} s; {used.ru_utime:.0f} s of the processor, {used.ru_maxrss // 1024} MB\n{done.stdout}", end="")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("executable")
    parser.add_argument("instances", nargs="*")
    parser.add_argument("--data", default=os.path.join(HERE, "..", "..", "shared", "data", "3d"))
    parser.add_argument("--seconds", type=float, default=60)
    parser.add_argument("--work", type=float, default=0)
    parser.add_argument("--seeds", type=int, default=1)
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--mixed", type=int, default=0)
    parser.add_argument("--runs", default="")
    arguments = parser.parse_intermixed_args()
    if arguments.mixed:
        return mixed_table(arguments)
    names = arguments.instances or SPARROW
    if arguments.runs:
        add_runs(arguments.runs, arguments.seconds, names, arguments.seeds,
                 lambda name, seed: one_run(arguments, name, seed))
    print("| instance | runs | mean | best | sparrow-3d mean | best | lower bound | first, s | last gain, s | processor, s |\n"
          "|---|---|---|---|---|---|---|---|---|---|")
    for name in names:
        runs = runs_of(arguments, name)
        heights = [run["curve"][-1][2] for run in runs]
        mean, best = SPARROW.get(name, ("", ""))
        print(f"| {name} | {len(runs)} | {sum(heights) / len(heights):.3f} | {min(heights):.3f} | {mean} | {best} | "
              f"{runs[0]['bound']} | {max(run['curve'][0][0] for run in runs):.2f} | "
              f"{max(run['curve'][-1][0] for run in runs):.1f} | {sum(run['processor'] for run in runs) / len(runs):.0f} |",
              flush=True)
    return None


if __name__ == "__main__":
    main()
