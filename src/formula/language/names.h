// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The vocabulary of the formula language: one table row for every word that names a distance or a predicate, with the
// meaning it has in terms of the canonical distances. Lexer, parser, printer, messages and docs/formula.md all
// speak from these tables, so a new distance is one row here (and one file in src/distance).
//
// Source: Pustylnik, arXiv:0808.2931v1, for the distances and their letters.
// Keywords: vocabulary, synonym, keyword, did you mean, edit distance.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace findspace::formula {

/// The canonical distances, in the order in which results list them.
enum class Kind : std::uint8_t {
  kGamma1,      // signed minimum translational distance: gap, or minus the penetration depth
  kGamma2,      // largest distance between points of the two shapes
  kEta1,        // signed distance of the first shape to being contained in the second
  kEta2,        // largest translation to an inner touching
  kDelta1,      // signed distance of the first shape to covering the second
  kDelta2,      // largest translation to a covering touch
  kMu,          // signed directed Hausdorff distance from the first to the second
  kHausdorff,   // Hausdorff distance
  kD1,          // plain distance: max(0, gamma1)
  kD2,          // plain farthest distance: gamma2
  kH,           // directed Hausdorff distance: max(0, mu)
  kDstar,       // distance of the second shape to the complement of the first
  kDiameter,    // diameter of the union
  kPenetration  // max(0, -gamma1)
};
inline constexpr std::size_t kKindCount = 14;

enum class Relation : std::uint8_t { kLess, kLessEqual, kEqual, kNotEqual, kGreaterEqual, kGreater };

/// `a R b` is `b mirrored(R) a`, and also `-a mirrored(R) -b`.
Relation mirrored(Relation relation);

/// One word for a distance. Its value at (first, second) is that of `kind` at (first, second), or at (second, first)
/// if `exchanged`, times -1 if `negated`.
struct DistanceName {
  std::string_view name;
  Kind kind;
  bool exchanged = false;
  bool negated = false;
};

/// One word for a predicate: `kind(first, second) relation level`, where the level is the third argument, times -1
/// if `negated`.
struct PredicateName {
  enum class Level : std::uint8_t { kNone, kOptional, kRequired };  // kNone, and kOptional when left out: level 0
  std::string_view name;
  Kind kind;
  Relation relation;
  Level level;
  bool negated;
};

/// All words; canonical names come first, in the order of Kind.
std::span<const DistanceName> distance_names();
std::span<const PredicateName> predicate_names();

/// The row of a word, or nullptr. Greek letters and subscript digits are read as their ASCII spelling (γ₁ is gamma1).
const DistanceName* find_distance(std::string_view word);
const PredicateName* find_predicate(std::string_view word);

/// The plain word of a distance: gap, reach, margin, cover, protrusion, hausdorff, distance, depth; of the others the
/// canonical one.
const DistanceName& plain_name(Kind kind);
/// The formula name ("gamma1") and the symbol of the literature, where it has one ("γ₁", otherwise the name).
std::string_view name(Kind kind);
std::string_view symbol(Kind kind);

/// kind(B, A) = kind(A, B) for all shapes.
bool is_symmetric(Kind kind);
/// Whether along=, toward= and rotating= are defined for it: gamma, eta and delta.
bool is_directional(Kind kind);

/// The candidate nearest to `word` by edit distance (insertion, deletion, exchange of neighbours, replacement; case is
/// free), or "" if none is near enough to be worth a question. Cost: |word| times the candidates' total length.
std::string nearest(std::string_view word, std::span<const std::string> candidates);

}  // namespace findspace::formula
