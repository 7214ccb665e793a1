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
#include "io/text/outline_shapes.h"

namespace findspace::io {
namespace {

using exact::Real;
using plane::ShapePtr;

constexpr int kMostGeometryDepth = 50;

class WktReader {
 public:
  WktReader(std::string_view text, const std::string& name, ReadContext& context, Real scale)
      : text_(text), name_(name), context_(context), scale_(std::move(scale)) {}

  std::vector<ShapePtr> read() {
    std::vector<ShapePtr> shapes;
    for (skip_blanks(); at_ < text_.size(); skip_blanks()) {
      shapes.push_back(geometry(0));
      skip_blanks();
      if (at_ < text_.size() && (text_[at_] == ';' || text_[at_] == ',')) ++at_;
    }
    return shapes;
  }

 private:
  [[noreturn]] void fail(ErrorCode code, const std::string& message) const {
    throw Error(code, message, text_place(text_, at_, name_));
  }
  /// Geometry errors get the place where the geometry begins.
  template <class Action>
  auto placed(std::size_t start, Action action) const {
    try {
      return action();
    } catch (const Error& e) {
      if (!e.place().empty()) throw;
      throw e.within(text_place(text_, start, name_));
    }
  }

  void skip_blanks() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_]))) ++at_;
  }

  std::string word() {
    skip_blanks();
    std::string letters;
    while (at_ < text_.size() && std::isalpha(static_cast<unsigned char>(text_[at_]))) {
      letters += static_cast<char>(std::toupper(static_cast<unsigned char>(text_[at_++])));
    }
    return letters;
  }

  bool take(char c) {
    skip_blanks();
    if (at_ >= text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }

  void need(char c) {
    if (take(c)) return;
    if (at_ >= text_.size()) fail(ErrorCode::kSyntax, fmt::format("the text ends where '{}' is expected", c));
    fail(ErrorCode::kSyntax, fmt::format("'{}' is expected, not '{}'", c, text_[at_]));
  }

  Real number() {
    skip_blanks();
    std::size_t length = scan_number(text_.substr(at_));
    if (length == 0)
      fail(ErrorCode::kSyntax,
           at_ >= text_.size() ? "the text ends where a number is expected" : "a number is expected");
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
    if (at_ < text_.size() && scan_number(text_.substr(at_)) > 0) {
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

  std::string kind() {
    std::string name = word();
    if (name == "SRID") {
      need('=');
      number();
      need(';');
      name = word();
    }
    if (name.empty()) fail(ErrorCode::kSyntax, "the name of a geometry is expected");
    std::size_t back = at_;
    std::string tag = word();
    if (tag == "Z" || tag == "M" || tag == "ZM")
      fail(ErrorCode::kUnsupported, "Z and M coordinates; only flat geometries are read");
    if (tag == "EMPTY") fail(ErrorCode::kGeometry, "an empty geometry");
    at_ = back;
    return name;
  }

  ShapePtr geometry(int depth) {
    if (depth > kMostGeometryDepth) fail(ErrorCode::kUnsupported, "geometries nested too deeply");
    skip_blanks();
    std::size_t start = at_;
    std::string name = kind();
    return placed(start, [&] { return geometry(name, start, depth); });
  }

  ShapePtr geometry(const std::string& name, std::size_t start, int depth) {
    std::string place = text_place(text_, start, name_);
    Outline outline(context_, scale_);
    if (name == "POLYGON" || name == "CURVEPOLYGON") return polygon(name == "CURVEPOLYGON", place);
    if (name == "MULTIPOLYGON" || name == "MULTISURFACE" || name == "GEOMETRYCOLLECTION")
      return several(name, place, depth);
    if (name == "POINT" || name == "MULTIPOINT") {
      points(outline);
    } else if (name == "LINESTRING" || name == "CIRCULARSTRING" || name == "COMPOUNDCURVE") {
      curve(name, outline);
    } else if (name == "MULTILINESTRING" || name == "MULTICURVE") {
      need('(');
      do curve(member(), outline);
      while (take(','));
      need(')');
    } else {
      at_ = start;
      fail(ErrorCode::kUnknownName, fmt::format("'{}' is no geometry that is read", name));
    }
    return lines_of(outline.take(), context_, place);
  }

  /// The kind of a member curve: a parenthesis without a word is a LINESTRING.
  std::string member() {
    std::string name = word();
    return name.empty() ? "LINESTRING" : name;
  }

  ShapePtr several(const std::string& name, const std::string& place, int depth) {
    std::vector<ShapePtr> parts;
    need('(');
    do {
      skip_blanks();
      bool plain = at_ < text_.size() && text_[at_] == '(';
      if (plain && name == "GEOMETRYCOLLECTION") fail(ErrorCode::kSyntax, "the name of a geometry is expected");
      std::size_t start = at_;
      parts.push_back(plain ? placed(start, [&] { return polygon(false, text_place(text_, start, name_)); })
                            : geometry(depth + 1));
    } while (take(','));
    need(')');
    return united(std::move(parts), place);
  }

  ShapePtr polygon(bool curves, const std::string& place) {
    Outline outline(context_, scale_);
    need('(');
    do {
      std::size_t start = at_;
      const std::size_t before = outline.drawn().chains.size();
      curve(curves ? member() : "LINESTRING", outline);
      if (outline.drawn().chains.size() != before + 1 || open_chains(outline.drawn()) > 0) {
        throw Error(ErrorCode::kGeometry, "a ring must end at its first point", text_place(text_, start, name_));
      }
    } while (take(','));
    need(')');
    return polygon_of(outline.take(), context_, place);
  }

  void points(Outline& outline) {
    need('(');
    do {
      bool nested = take('(');
      Position p = position();
      if (nested) need(')');
      outline.point(p.x, p.y);
    } while (take(','));
    need(')');
  }

  void curve(const std::string& name, Outline& outline) {
    if (name == "COMPOUNDCURVE") return compound(outline);
    run(name, outline, true);
    outline.finish();
  }

  void compound(Outline& outline) {
    need('(');
    bool first = true;
    do {
      run(member(), outline, first);
      first = false;
    } while (take(','));
    need(')');
    outline.finish();
  }

  void run(const std::string& name, Outline& outline, bool first) {
    std::size_t start = at_;
    std::vector<Position> p = positions();
    placed(start, [&] {
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

  std::string_view text_;
  const std::string& name_;
  ReadContext& context_;
  Real scale_;
  std::size_t at_ = 0;
};

}  // namespace

ShapePtr read_wkt(std::string_view text, const std::string& name, const FileChoice& choice, ReadContext& context) {
  refuse_choice(choice.id.has_value(), "id", "WKT", name);
  refuse_choice(choice.layer.has_value(), "layer", "WKT", name);
  Real scale = file_scale(std::nullopt, name, choice, context);
  return chosen(WktReader(text, name, context, scale).read(), name, choice);
}

}  // namespace findspace::io
