# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Runs by the clock that a file keeps, each as a line of JSON: a table of many runs may take several days."""
import json
import os


def kept_runs(path, seconds):
    """The lines of the file that were run for as long; each names its instance and seed."""
    if not os.path.exists(path):
        return []
    with open(path, encoding="utf-8") as file:
        lines = [json.loads(line) for line in file if line.strip()]
    return [line for line in lines if line["seconds"] == seconds]


def add_runs(path, seconds, names, seeds, run_once):
    """Runs what the file does not hold, all instances with one seed before the next: run_once(name, seed) gives a line."""
    done = {(line["instance"], line["seed"]) for line in kept_runs(path, seconds)}
    for seed in range(1, seeds + 1):
        for name in names:
            if (name, seed) in done:
                continue
            line = {"instance": name, "seed": seed, "seconds": seconds, **run_once(name, seed)}
            with open(path, "a", encoding="utf-8") as file:
                file.write(json.dumps(line) + "\n")
