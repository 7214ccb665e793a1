# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Worlds, formulas and regions travel to other processes: 1,000 scenes over two workers of a local dask cluster."""
import random

import pytest

import findspace as fs

distributed = pytest.importorskip("distributed")
SCENES = 1000


def scene(seed):
    rng = random.Random(seed)
    shapes = {"table": fs.Shape.box((0, 0), (40, 30)), "peg": fs.Shape.disc((0, 0), rng.randint(1, 3))}
    for k in range(3):
        x, y = rng.randint(0, 30), rng.randint(0, 20)
        shapes[f"part{k}"] = fs.Shape.polygon([[x, y], [x + rng.randint(2, 9), y], [x, y + rng.randint(2, 9)]])
    return fs.World(shapes, moving="peg")


def where():
    formula = fs.inside("peg", "table")
    for k in range(3):
        formula &= fs.clear("peg", f"part{k}", "0.5")
    return formula


def solved(asked):
    world, formula = asked
    region = world.solve(formula)
    return region, world.query("gap(peg, part0)").values([[20, 15]])[0]


def test_a_thousand_scenes_over_two_workers(tmp_path):
    worlds = [scene(seed) for seed in range(SCENES)]
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None,
                                  local_directory=str(tmp_path)) as cluster, distributed.Client(cluster) as client:
        told = client.gather(client.map(solved, [(world, where()) for world in worlds], batch_size=100))
        assert len(client.scheduler_info()["workers"]) == 2
    assert len(told) == SCENES
    for world, (region, gap) in list(zip(worlds, told))[::10]:
        here, value = solved((world, where()))
        assert region == here and gap == value
