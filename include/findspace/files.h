// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Files: what reading a scene or a packing problem may open and cost, and how the drawings and meshes in it are read:
// what becomes of curves beyond arcs, of outlines with gaps, and of surfaces with slits and holes; how drawings are
// written. The defaults are those of the program and of the library alike (docs/security.md). Guarantee: what goes
// beyond is refused with Error(kLimit) or Error(kUnsupported), and nothing else is opened. Keywords: sandbox, quota,
// zip bomb, tolerance, chaining, gap closing.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace findspace {

/// Which DXF is written: R12, which every program reads, or 2000, in which layers may have any name.
enum class DxfVersion { kR12, k2000 };

/// Where the arcs that stand for a curve lie: on either side, or so that the set is inside (outside) the true one.
enum class CurveRule { kNear, kInside, kOutside };

/// What the parts of a drawing are: all outlines together, each element as the area that it encloses, or each outline
/// that lies in no other, with its holes.
enum class PartRule { kOne, kElements, kOutlines };

/// Rules of drawings and meshes. Those given here come before those beside a shape, which come before a scene's.
struct DrawingRules {
  std::optional<CurveRule> curves = {};         // on which side arcs lie that stand for curves
  std::optional<std::string> tolerance = {};    // a length as text: "0.001mm", or a number in the scene's unit
  std::optional<std::string> join = {};         // the widest gap that is closed
  std::optional<std::string> mend = {};         // the widest crossing of outlines that is mended; 0: none
  std::optional<bool> open_lines = {};          // open outlines are lines, not errors
  std::optional<PartRule> parts = {};           // docs/scene.md says what holds where it is unset
  std::optional<std::string> repair = {};       // of meshes: the width within which open edges are joined
  std::optional<std::string> close_holes = {};  // of meshes: how wide holes may be that are closed

  /// These where they say something, else those.
  DrawingRules over(const DrawingRules& those) const;
};

/// The endings of drawings (2) or of meshes and models (3) that shapes are read from, in small letters: ".dxf", ".stl".
std::vector<std::string> drawing_endings(int dimension);

inline constexpr std::uint64_t kUsualInput = std::uint64_t{256} << 20;  // bytes
inline constexpr std::uint64_t kUsualWork = 20'000'000;                 // units

struct ReadOptions {
  bool files = true;                        // whether shapes may come from other files
  std::string root = {};                    // these lie in this folder, links followed; empty: anywhere
  std::uint64_t input_limit = kUsualInput;  // bytes of all files together, packed ones as they are unpacked
  std::uint64_t work_limit = kUsualWork;    // units, of reading, of each shape, each formula and of searches in space
  DrawingRules drawings = {};               // before those that the scene states
};

}  // namespace findspace
