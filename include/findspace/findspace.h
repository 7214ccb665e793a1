// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// findspace: the exact set of all positions of a part. Everything a user of the library needs; no third-party header is
// included.
//   number.h, contour.h   exact numbers and points; rings with arcs
//   shape.h     what there is: polygons, discs, solids, and what operations make of them
//   formula.h   what is asked: distances compared with levels, as objects or as text
//   world.h     which shape moves, and the questions: distances, sign maps, formulas, optima, queries
//   values.h    what is said about one position
//   scene.h, answer.h   scene files, and the program's questions about them
//   motion.h, line_map.h   shapes that move in time, poses; regions of space on lines
//   placement.h   several shapes put down
//   options.h   limits of questions, progress, cancellation
//   store.h, team.h, stages.h   results kept between runs; processes that answer together; files of each stage
//   region.h    the answers: exact point sets
//   files.h     what reading may open and cost, versions of what is written
//   packing.h   many parts on a strip or on sheets; solid_packing.h: solids upon a floor or in containers
//   space_region.h, surface.h   exact sets of space, and surfaces
//   phi.h       Phi-functions with gradients
//   board.h     circuit boards: rules of their parts
//   vocabulary.h   the words that formulas are written with
//   text.h      files within limits, files written whole, and pieces of JSON; json.h: JSON read
//   error.h     what is thrown for bad input
#pragma once

#include "findspace/answer.h"
#include "findspace/board.h"
#include "findspace/contour.h"
#include "findspace/error.h"
#include "findspace/explanation.h"
#include "findspace/files.h"
#include "findspace/formula.h"
#include "findspace/json.h"
#include "findspace/line_map.h"
#include "findspace/motion.h"
#include "findspace/number.h"
#include "findspace/options.h"
#include "findspace/pack_search.h"
#include "findspace/packing.h"
#include "findspace/phi.h"
#include "findspace/placement.h"
#include "findspace/region.h"
#include "findspace/scene.h"
#include "findspace/shape.h"
#include "findspace/solid_packing.h"
#include "findspace/space_region.h"
#include "findspace/stages.h"
#include "findspace/store.h"
#include "findspace/surface.h"
#include "findspace/team.h"
#include "findspace/text.h"
#include "findspace/values.h"
#include "findspace/vocabulary.h"
#include "findspace/world.h"
