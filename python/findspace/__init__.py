# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Exact maps of where a part can go.

>>> import findspace as fs
>>> plate = fs.Shape.box((0, 0), (10, 6)) - fs.Shape.disc((5, 3), 1.5)
>>> world = fs.World({"plate": plate, "chip": fs.Shape.box((-1, -1), (1, 1))}, moving="chip", unit="mm")
>>> region = world.solve(fs.gap("chip", "plate") >= "0.5mm")
>>> (11.5, 3) in region, (11.4, 3) in region
(True, False)
"""
from ._findspace import (AdjustedPhi, AdjustedPhiValue, Answer, AtomValue, Board, BoardVerdict, Body, Cancel, Check, Component,
                         Distance, DistanceValue, DistanceWord, DrawingRules, Edge, Error, Explanation, Feature,
                         FixedPart, FixedSolid, Formula, Instants, Interval, LeftOutPart, LevelChange, LineMap, Measured,
                         Optimum, Options, Orientation, PackContainer, PackFault, PackGroup, PackLayout, PackPart,
                         PackProblem, PackProgress, PackRemnant, PackSheet, PackSolid, PackVerdict, PackZone, Packing,
                         Phi, PhiValue, PlacedPart, PlacedSolid, Placement, PoseMap, PredicateWord, Query, ReadOptions,
                         Region, ResultStore, Ring, Rotation, Scene, Shape, SignMap, SolidPackLayout, SolidPackProblem, SolidPacking,
                         SpaceRegion, Stopped, Surface, World, clear, cover, covers, depth, diameter, disjoint,
                         distance, distance_words, drawing_endings, far, gap, group, hausdorff, inside, keepout, margin, near,
                         nearest_word, overlaps, pack, place, predicate_words, protrusion, reach, touches, unit_words,
                         usual_distance_words, within)
from . import _page, _plot, _shapely

__all__ = ["AdjustedPhi", "AdjustedPhiValue", "Answer", "AtomValue", "Board", "BoardVerdict", "Body", "Cancel", "Check",
           "Component", "Distance", "DistanceValue", "DistanceWord", "DrawingRules", "Edge", "Error", "Explanation",
           "Feature", "FixedPart", "FixedSolid", "Formula", "Instants", "Interval", "LeftOutPart", "LevelChange",
           "LineMap", "Measured", "Optimum", "Options", "Orientation", "PackContainer", "PackFault", "PackGroup", "PackLayout",
           "PackPart", "PackProblem", "PackProgress", "PackRemnant", "PackSheet", "PackSolid", "PackVerdict",
           "PackZone", "Packing", "Phi", "PhiValue", "PlacedPart", "PlacedSolid", "Placement", "PoseMap",
           "PredicateWord", "Query", "ReadOptions", "Region", "ResultStore", "Ring", "Rotation", "Scene", "Shape", "SignMap", "SolidPackLayout",
           "SolidPackProblem", "SolidPacking", "SpaceRegion", "Stopped", "Surface", "World", "clear", "cover",
           "covers", "depth", "diameter", "disjoint", "distance", "distance_words", "drawing_endings", "far", "gap", "group", "hausdorff",
           "inside", "keepout", "margin", "near", "nearest_word", "overlaps", "pack", "place", "predicate_words",
           "protrusion", "reach", "shape", "touches", "unit_words", "usual_distance_words", "within"]

shape = _shapely.shape
Region.plot = _plot.plot_region
Region._repr_svg_ = _plot.picture
Shape.plot = _plot.plot_shape
Shape._repr_svg_ = _plot.picture_of_shape
SpaceRegion._repr_svg_ = _plot.picture_of_solid
Surface._repr_svg_ = _plot.picture_of_surface
Shape._repr_html_ = _page.page_of_shape
Surface._repr_html_ = _page.page_of_surface
SpaceRegion._repr_html_ = _page.page_of_region
Placement._repr_svg_ = _plot.picture_of_placement
PackLayout._repr_svg_ = _plot.picture_of_layout
SolidPackLayout._repr_svg_ = _plot.picture_of_layout
SolidPackLayout._repr_html_ = _page.page_of_layout
Region.to_shapely = _shapely.to_shapely
Region.__geo_interface__ = property(_shapely.geo_interface)
Shape.__geo_interface__ = property(_shapely.geo_interface_of_shape)
Shape.to_shapely = _shapely.shape_to_shapely
