// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Well-known text (OGC 06-103r4), with circular arcs as in SQL/MM: POINT MULTIPOINT LINESTRING MULTILINESTRING POLYGON
// MULTIPOLYGON CIRCULARSTRING COMPOUNDCURVE CURVEPOLYGON MULTICURVE MULTISURFACE GEOMETRYCOLLECTION. Several geometries
// may follow each other; `index` chooses. "SRID=n;" before a geometry is passed over; Z and M are refused.
#include <fmt/format.h>

#include <array>
#include <cctype>

#include "findspace/error.h"
#include "io/read/read_file.h"
#include "io/text/file_kind.h"
#include "io/text/outline_shapes.h"

namespace findspace::io {
namespace {

using exact::Real;
using plane::ShapePtr;

constexpr int kMostGeometryDepth = 50;

/// The words, numbers and marks of the text, one after another, and the places for messages.
class WktScanner {
 public:
  WktScanner(std::string_view text, const std::string& name) : text_(text), places_(text, name) {}

  std::size_t at() const { return at_; }
  void go_to(std::size_t at) { at_ = at; }
  bool done() const { return at_ >= text_.size(); }
  std::string place(std::size_t at) const { return places_.at(at); }
  /// Whether `c` is next; it is not taken.
  bool sees(char c) const { return !done() && text_[at_] == c; }

  [[noreturn]] void fail(ErrorCode code, const std::string& message) const { throw Error(code, message, place(at_)); }
  /// Geometry errors get the place where the geometry begins.
  template <class Action>
  auto placed(std::size_t start, Action action) const {
    try {
      return action();
    } catch (const Error& e) {
      if (!e.place().empty()) throw;
      throw e.within(place(start));
    }
  }

  void skip_blanks() {
    while (!done() && std::isspace(static_cast<unsigned char>(text_[at_]))) ++at_;
  }

  std::string word() {
    skip_blanks();
    std::string letters;
    while (!done() && std::isalpha(static_cast<unsigned char>(text_[at_]))) {
      letters += static_cast<char>(std::toupper(static_cast<unsigned char>(text_[at_++])));
    }
    return letters;
  }

  bool take(char c) {
    skip_blanks();
    if (!sees(c)) return false;
    ++at_;
    return true;
  }

  void need(char c) {
    if (take(c)) return;
    if (done()) fail(ErrorCode::kSyntax, fmt::format("the text ends where '{}' is expected", c));
    fail(ErrorCode::kSyntax, fmt::format("'{}' is expected, not '{}'", c, text_[at_]));
  }

  Real number() {
    skip_blanks();
    std::size_t length = scan_number(text_.substr(at_));
    if (length == 0)
      fail(ErrorCode::kSyntax, done() ? "the text ends where a number is expected" : "a number is expected");
    at_ += length;
    return placed(at_ - length, [&] { return Real::parse_decimal(text_.substr(at_ - length, length)); });
  }

  struct Position {
    Real x, y;
  };
  Position position() {
    Real x = number();
    Real y = number();
    skip_blanks();
    if (!done() && scan_number(text_.substr(at_)) > 0) {
      fail(ErrorCode::kUnsupported, "a third coordinate; only flat geometries are read");
    }
    return {x, y};
  }

  std::vector<Position> positions() {
    std::vector<Position> all;
    need('(');
    do all.push_back(position());
    while (take(','));
    need(')');
    return all;
  }

 private:
  std::string_view text_;
  TextPlaces places_;
  std::size_t at_ = 0;
};

class WktReader {
 public:
  WktReader(std::string_view text, const std::string& name, const FileChoice& choice, ReadContext& context, Real scale)
      : from_(text, name), name_(name), choice_(choice), context_(context), scale_(std::move(scale)) {}

  std::vector<ShapePtr> read() {
    std::vector<ShapePtr> shapes;
    for (from_.skip_blanks(); !from_.done(); from_.skip_blanks()) {
      shapes.push_back(geometry(0));
      if (!from_.take(';')) from_.take(',');
    }
    if (!nests(choice_, context_) || outlines_ < 2) return shapes;
    context_.repeated_points = repeated_;  // they are met again
    return closed_parts(std::move(pool_), context_, name_);
  }

 private:
  using Position = WktScanner::Position;

  std::string kind() {
    std::string name = from_.word();
    if (name == "SRID") {
      from_.need('=');
      from_.number();
      from_.need(';');
      name = from_.word();
    }
    if (name.empty()) from_.fail(ErrorCode::kSyntax, "the name of a geometry is expected");
    const std::size_t back = from_.at();
    std::string tag = from_.word();
    if (tag == "Z" || tag == "M" || tag == "ZM")
      from_.fail(ErrorCode::kUnsupported, "Z and M coordinates; only flat geometries are read");
    if (tag == "EMPTY") from_.fail(ErrorCode::kGeometry, "an empty geometry");
    from_.go_to(back);
    return name;
  }

  /// The kind of a member curve: a parenthesis without a word is a LINESTRING.
  std::string member() {
    std::string name = from_.word();
    return name.empty() ? "LINESTRING" : name;
  }

  ShapePtr geometry(int depth) {
    if (depth > kMostGeometryDepth) from_.fail(ErrorCode::kUnsupported, "geometries nested too deeply");
    from_.skip_blanks();
    std::size_t start = from_.at();
    std::string name = kind();
    return from_.placed(start, [&] { return geometry(name, start, depth); });
  }

  ShapePtr geometry(const std::string& name, std::size_t start, int depth) {
    std::string place = from_.place(start);
    Outline outline(context_, scale_);
    if (name == "POLYGON" || name == "CURVEPOLYGON") return polygon(name == "CURVEPOLYGON", place);
    if (name == "MULTIPOLYGON" || name == "MULTISURFACE" || name == "GEOMETRYCOLLECTION")
      return several(name, place, depth);
    if (name == "POINT" || name == "MULTIPOINT") {
      points(outline);
    } else if (name == "LINESTRING" || name == "CIRCULARSTRING" || name == "COMPOUNDCURVE") {
      curve(name, outline);
    } else if (name == "MULTILINESTRING" || name == "MULTICURVE") {
      from_.need('(');
      do curve(member(), outline);
      while (from_.take(','));
      from_.need(')');
    } else {
      from_.go_to(start);
      from_.fail(ErrorCode::kUnknownName, fmt::format("'{}' is not a geometry that is read", name));
    }
    pool(outline.drawn());
    return lines_of(outline.take(), context_, place);
  }

  void pool(const Drawing& drawing) {
    ++outlines_;
    append(pool_, drawing);
  }

  ShapePtr several(const std::string& name, const std::string& place, int depth) {
    std::vector<ShapePtr> parts;
    from_.need('(');
    do {
      from_.skip_blanks();
      bool plain = from_.sees('(');
      if (plain && name == "GEOMETRYCOLLECTION") from_.fail(ErrorCode::kSyntax, "the name of a geometry is expected");
      std::size_t start = from_.at();
      parts.push_back(plain ? from_.placed(start, [&] { return polygon(false, from_.place(start)); })
                            : geometry(depth + 1));
    } while (from_.take(','));
    from_.need(')');
    return united(std::move(parts), place);
  }

  ShapePtr polygon(bool curves, const std::string& place) {
    Outline outline(context_, scale_);
    from_.need('(');
    do {
      std::size_t start = from_.at();
      const std::size_t before = outline.drawn().chains.size();
      curve(curves ? member() : "LINESTRING", outline);
      const std::vector<Chain>& rings = outline.drawn().chains;
      if (rings.size() != before + 1 || !rings.back().closed)
        throw Error(ErrorCode::kGeometry, "a ring must end at its first point", from_.place(start));
    } while (from_.take(','));
    from_.need(')');
    pool(outline.drawn());
    return polygon_of(outline.take(), context_, place);
  }

  void points(Outline& outline) {
    from_.need('(');
    do {
      bool nested = from_.take('(');
      Position p = from_.position();
      if (nested) from_.need(')');
      outline.point(p.x, p.y);
    } while (from_.take(','));
    from_.need(')');
  }

  void curve(const std::string& name, Outline& outline) {
    if (name == "COMPOUNDCURVE") return compound(outline);
    run(name, outline, true);
    outline.finish();
  }

  void compound(Outline& outline) {
    from_.need('(');
    bool first = true;
    do {
      run(member(), outline, first);
      first = false;
    } while (from_.take(','));
    from_.need(')');
    outline.finish();
  }

  void run(const std::string& name, Outline& outline, bool first) {
    std::size_t start = from_.at();
    std::vector<Position> p = from_.positions();
    from_.placed(start, [&] {
      if (first) {
        outline.move_to(p[0].x, p[0].y);
      } else if (!outline.is_at(p[0].x, p[0].y)) {
        throw Error(ErrorCode::kGeometry, "a part of a compound curve does not begin where the one before ends");
      }
      if (name == "LINESTRING") {
        for (std::size_t i = 1; i < p.size(); ++i) outline.line_to(p[i].x, p[i].y);
      } else if (name == "CIRCULARSTRING" && p.size() % 2 == 1 && p.size() >= 3) {
        for (std::size_t i = 1; i < p.size(); i += 2) outline.through_to(p[i].x, p[i].y, p[i + 1].x, p[i + 1].y);
      } else {
        throw Error(ErrorCode::kSyntax, name == "CIRCULARSTRING"
                                            ? "a circular string needs an odd number of points, at least 3"
                                            : fmt::format("'{}' cannot stand here", name));
      }
    });
  }

  WktScanner from_;
  const std::string& name_;
  const FileChoice& choice_;
  ReadContext& context_;
  Real scale_;
  Drawing pool_;  // the outlines of all geometries
  int outlines_ = 0;
  std::int64_t repeated_ = context_.repeated_points;  // before
};

}  // namespace

ShapePtr read_wkt(std::string_view text, const std::string& name, const FileChoice& choice, ReadContext& context) {
  refuse_choice(choice.id.has_value(), "id", "WKT", name);
  refuse_choice(choice.layer.has_value(), "layer", "WKT", name);
  Real scale = file_scale(std::nullopt, name, choice, context);
  text = without_byte_order_mark(text);
  return chosen(WktReader(text, name, choice, context, scale).read(), name, choice);
}

}  // namespace findspace::io
