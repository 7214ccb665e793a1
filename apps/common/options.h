// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The command line as values, and what a verb gives back.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "findspace/files.h"
#include "findspace/text.h"

namespace findspace {
class Team;
}

namespace findspace::app {

struct Options {
  std::string scene;                           // a path, or "-": standard input
  std::optional<std::string> scene_text;       // the scene itself; `scene` is then what messages call it
  std::vector<std::string> shapes;             // of describe, convert, phi; further words of pack and verify
  std::vector<std::filesystem::path> outputs;  // format by ending
  std::optional<std::string> at;               // "x,y": decimals, taken exactly
  std::optional<std::string> angle;  // of check and measure: degrees the moving shape is rotated by, taken exactly
  std::optional<std::string> orientation;                 // of these in space: "w,x,y,z", "1,1,0:45" or nine numbers
  std::optional<std::string> time;                        // an instant of the motion, a decimal
  std::optional<std::string> min_distance, max_distance;  // of phi: allowed distances, decimals
  std::vector<std::string> move, free;         // of a board: parts that move; angles they may have, in degrees
  std::vector<std::string> fixed, groups;      // of a board: parts that must not move; "NAME=PART,PART"
  std::string where, minimize, maximize;       // formulas, before those of a scene; of a board
  bool place = false;                          // the verb is `place`
  std::string apply;                           // of map: interior closure boundary regularize complement, or nothing
  std::optional<std::string> unit, id, layer;  // of convert, for a file that is not a scene
  std::optional<unsigned> index;
  std::string floor;          // of a grid of heights
  bool exact = false;         // of map, describe: the exact cells in the JSON
  bool constructive = false;  // of convert: JSON is a scene that states the shape constructively
  bool all = false;           // of measure: all distances, or
  std::string only;           // this one
  bool explain = false;       // of check: which way decided each atom, and how long it took
  int port = 0;               // of view; 0: any
  bool no_open = false;       // of view: print the link only
  bool stdio = false;         // of serve: requests on standard input
  bool json = false, quiet = false;
  std::string side;                // of map and describe in 3D: inner or outer cells about lines, or nothing
  bool axes = false;               // of these: lines along all three axes, or
  std::string axis;                // along this one: x, y, z, or nothing
  int resolution = 0;              // of these and place: lines each way; 0: an exact map, or by
  std::string spacing;             // how far the lines are apart, a decimal, or nothing
  unsigned threads = 0;            // 0: one for each core
  double time_limit = 0;           // seconds; 0: none
  std::uint64_t memory_limit = 0;  // bytes; 0: none
  bool no_files = false;           // shapes come from the scene alone, or
  std::filesystem::path root;      // from files in this folder
  std::uint64_t input_limit = kUsualInput, work_limit = kUsualWork;  // findspace/files.h
  std::filesystem::path store;                                       // the folder of results that are kept; empty: none
  std::uint64_t store_limit = std::uint64_t{1} << 30;                // bytes
  DrawingRules drawings;                                             // before those of the scene
  DxfVersion dxf = DxfVersion::kR12;                                 // of drawings that are written
  std::optional<std::string> height;           // of pack and verify: of the strip, instead of the file's
  std::string gap = "0", edge = "0";           // of pack and verify: least distances
  std::optional<std::string> sheet;            // of pack and verify, for drawings: "W,H", decimals
  std::vector<std::string> angles;             // of these: allowed, in degrees
  bool mirrored = false;                       // of these: they may be turned over
  std::optional<std::string> tilt;             // of these: degrees off the angles
  std::optional<std::filesystem::path> start;  // of pack: a layout
  std::uint64_t seed = 1;                      // of pack
  unsigned workers = 0;                        // of batch; 0: one for each core
  bool as_they_come = false;                   // of batch: print results too
  Team* team = nullptr;                        // processes that answer one question together, or none
  double work = 0;                             // of pack: millions of evaluations a thread; 0: no limit
};

/// What reading may open and cost, and how drawings are read.
inline ReadOptions reading(const Options& o) { return {!o.no_files, o.root, o.input_limit, o.work_limit, o.drawings}; }

/// What stands between commas.
inline std::vector<std::string> at_commas(const std::string& text) {
  std::vector<std::string> parts{""};
  for (const char c : text) {
    if (c == ',')
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

/// Whether the answer is printed, besides the files.
inline bool is_printed(const Options& o) { return o.json || !o.quiet || o.outputs.empty(); }

/// Exit statuses (docs/commands.md).
enum ExitStatus { kDone = 0, kEmpty = 1, kUsage = 2, kBadInput = 3, kLimit = 4, kInternal = 70, kInterrupted = 130 };

struct Outcome {
  std::string text;  // for standard output
  ExitStatus status = kDone;
  std::function<void(const TextSink&)> stream = {};  // gives what is too long for memory, instead of the text
};

}  // namespace findspace::app
