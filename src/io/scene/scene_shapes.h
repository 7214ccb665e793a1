// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// From the `shapes` of a scene to trees. A kind of shape is a row of a table: its key, the keys it may have beside it,
// and the function that builds it. The tables: primitives (scene_primitives.cpp), constructive nodes
// (scene_nodes.cpp), 3D primitives (scene_space.cpp). A new kind is one row and one function there.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "io/text/scene_reader.h"

namespace findspace::io {

class ShapeReader;

struct ShapeKind {
  std::string_view key;
  std::vector<std::string_view> beside;  // optional keys; what is required the function asks for
  /// `object` holds the key, `value` is what stands there.
  plane::ShapePtr (*build)(ShapeReader& reader, const JsonValue& object, const JsonValue& value, const Label& label);
};

std::span<const ShapeKind> primitive_kinds();
std::span<const ShapeKind> node_kinds();
std::span<const ShapeKind> space_kinds();
/// A box with three coordinates.
plane::ShapePtr build_space_box(ShapeReader& reader, const JsonValue& object, const JsonValue& value,
                                const Label& label);

class ShapeReader {
 public:
  /// `shapes` is the object under that key; it must outlive the reader.
  ShapeReader(const SceneReader& json, const JsonValue& shapes);

  const SceneReader& json() const { return json_; }
  ReadContext& context() const { return json_.context(); }
  /// 2 or 3; 2 while no shape has said.
  int dimension() const { return dimension_ == 0 ? 2 : dimension_; }
  /// 2 or 3; 0 while no shape has said.
  int stated_dimension() const { return dimension_; }

  /// All named shapes, in the order of the file.
  std::vector<plane::ShapePtr> all();
  /// A shape as values state it: a name, an object or a list (a collection).
  plane::ShapePtr shape(const JsonValue& value, const Label& label);
  /// The shape of that name; errors are placed at `at`.
  plane::ShapePtr named(std::string_view name, const JsonValue& at, const Label& label);
  const std::vector<std::string>& names() const { return names_; }

  /// A new node that knows its place.
  plane::Shape node(plane::Shape::Kind kind, const Label& label, const JsonValue& at) const;
  /// In 3D: charges for the pairs of parts of a Minkowski sum or difference, as far as the tree says them. One part
  /// with many costs nothing: that is as much as the many.
  void charge_pairs(const plane::Shape& sum);
  /// In 3D: charges for the copy that a rotation makes of the tree. Solids that a file or the scene states and that are
  /// rotated once cost nothing: they have been paid.
  void charge_rotated(const plane::Shape& shape);
  /// What the rotation made: to rotate it again is charged.
  void note_rotated(const plane::Shape& made);
  /// Records that the scene is 2D or 3D; refuses a mixture.
  void use_dimension(int dimension, const Label& label, const JsonValue& at);

 private:
  struct Entry {
    const JsonValue* value = nullptr;
    plane::ShapePtr shape;
    std::size_t height = 0;  // levels of its tree
    bool open = false;       // being built: meeting it again is a cycle
  };

  plane::ShapePtr object(const JsonValue& value, const Label& label);
  plane::ShapePtr list(const JsonValue& value, const Label& label);
  [[noreturn]] void fail_unknown_kind(const JsonValue& value, const Label& label) const;
  [[noreturn]] void fail_too_deep(const JsonValue& at, const Label& label) const;
  [[noreturn]] void fail_cycle(std::string_view name, const JsonValue& at, const Label& label) const;

  /// In 3D: charges for the parts of a shape that is an operand by its name, and was before.
  void charge_copy(const plane::Shape& named);
  void charge(double units, std::string_view what);
  /// Convex parts that a shape may have, were each of its solids one.
  double parts_of(const plane::Shape& shape);

  const SceneReader& json_;
  plane::WorkBudget parts_work_;  // for parts of sums and of copies
  std::unordered_map<const plane::Shape*, double> parts_;
  std::unordered_set<const plane::Shape*> operands_;                // by their names
  std::set<std::weak_ptr<const void>, std::owner_less<>> rotated_;  // solids
  std::vector<std::string> names_;
  std::map<std::string, Entry, std::less<>> entries_;
  std::vector<std::string> trail_;  // names being built, outermost first
  std::size_t height_ = 0;  // levels of the highest tree among the operands read so far of the shape that is read
  std::size_t depth_ = 0;   // shapes that are being read, each an operand of the one before
  int dimension_ = 0;
};

plane::ShapePtr share(plane::Shape shape);

}  // namespace findspace::io
