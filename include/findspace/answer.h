// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What a scene answers (scene.h): yes, no or neither, the numbers behind it, and the same words, JSON and files as the
// program's. An Answer is an immutable value, cheap to copy; reading it from many threads is safe. Guarantee: that of
// the question. Cost: texts and pictures are made when they are asked for. Source: docs/results.md. Keywords: result,
// report.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "findspace/explanation.h"
#include "findspace/files.h"
#include "findspace/line_map.h"
#include "findspace/motion.h"
#include "findspace/placement.h"
#include "findspace/region.h"
#include "findspace/space_region.h"
#include "findspace/values.h"
#include "findspace/world.h"

namespace findspace {

/// How an answer is told.
struct Telling {
  bool all = false;                   // measurements: every distance, not only the usual ones and those of the formula
  bool explain = false;               // checks: which way decided each condition, and how long it took
  bool exact = false;                 // JSON of maps: with the exact cells
  DxfVersion dxf = DxfVersion::kR12;  // drawings
};

/// One distance of a measurement.
struct Measured {
  std::string text;                      // "gap(B, A)"
  std::optional<DistanceValue> value{};  // in the scene's unit, or degrees; nothing: not computed
  std::string refused{};                 // why it is not computed, else empty
};

/// The feasible position that is nearest to another one, or such a one of the closure.
struct NearestPlace {
  Place at{};             // two coordinates, or three
  double distance = 0;    // how far it is from there
  bool attained = false;  // whether it is feasible itself, not only others as near to it as you like
};

class Answer {
 public:
  /// Yes; no, which is proven; or neither, as only bounds are known or a limit came first.
  enum class Found { kYes, kNo, kUndecided };
  /// Whether the formula holds there; of a placement whether all have a place; or of a map or an explanation anywhere;
  /// of a measurement kYes; of a shape whether anything belongs to it. On a line of space between bounds: whether the
  /// intervals that the text gives are some.
  Found found() const;

  /// In words, as the program prints it.
  std::string text(const Telling& telling = {}) const;
  /// As the program prints it with --json (docs/results.md).
  std::string json(const Telling& telling = {}) const;
  /// The endings of the files that it can be: ".json", ".svg", of maps ".wkt" and ".dxf" too, in space surfaces.
  std::vector<std::string> endings() const;
  /// The text of such a file, and what it does not say. Error(kUnsupported) for another ending.
  Region::Drawn file(std::string_view ending, const Telling& telling = {}) const;
  /// The same, part by part: JSON of many lines need not be in memory as a whole.
  void write(std::string_view ending, const std::function<void(std::string_view)>& part,
             const Telling& telling = {}) const;
  /// Whether that JSON comes in parts.
  bool written_in_parts() const;
  /// What was rounded, and how far, or is not computed.
  const std::vector<std::string>& notes() const;

  /// Of a question about one position: which one, after snapping; empty of other answers.
  Place at() const;
  /// Of a check: every condition. Error(kBadValue) of other answers, kUnsupported where a value is not computed.
  Check check() const;
  /// The nearest feasible position: of a check that fails, and where that is the question. Nothing where there is none,
  /// or it is not computed.
  std::optional<NearestPlace> nearest() const;
  /// Of a measurement: its distances, pair by pair; none of other answers.
  std::vector<Measured> measured() const;

  /// Of a map of positions in the plane, all or those on a line: where the formula holds, or is best. Where the best
  /// value is known between bounds, `inner` has positions with the value found, which others may beat, and all
  /// positions at which the formula may hold are possible. Of a shape of the plane: its set, twice. Nothing of other
  /// answers.
  std::optional<RegionBounds> region() const;
  /// Of a map of positions in space: the same, exactly.
  std::optional<SpaceRegion> space_region() const;
  /// Of a map or a shape of space that has no exact form, or was asked for on lines: where these meet it, cast anew.
  /// Of lines along all axes, those along z. Nothing of other answers.
  std::optional<LineMap> on_lines() const;
  /// Of both: its surface; nothing of other answers, and of cells about lines.
  std::optional<Surface> surface() const;
  /// Whether it is one on lines. A map is found(), then, where a line shows it for certain, and not where cells about
  /// the lines show that nothing is.
  bool sampled() const;
  /// Of a map with an objective, or with `-> min`: the best value. Over angles, and in space, `at` is empty:
  /// intervals() and space_region() have them.
  std::optional<Optimum> best() const;
  /// Of a map of a line, by the length gone, of angles, in degrees, and of instants: where the formula holds for
  /// certain, or is best; and a set that holds all such. Empty of other answers.
  std::vector<Interval> intervals() const;
  std::vector<Interval> possible() const;
  /// Of a map of poses of the plane.
  std::optional<PoseMap> poses() const;

  /// Of an explanation.
  std::optional<Explanation> explanation() const;
  /// Of a placement: what was put where.
  std::optional<Placement> placement() const;

  struct Data;
  explicit Answer(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

 private:
  std::shared_ptr<const Data> data_;
};

}  // namespace findspace
