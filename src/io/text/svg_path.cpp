// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/text/svg_path.h"

#include <fmt/format.h>

#include "exact/planar/angle.h"
#include "findspace/error.h"
#include "io/text/units.h"

namespace findspace::io {
namespace {

using exact::Real;

class PathReader {
 public:
  PathReader(std::string_view data, PathSink& sink) : data_(data), sink_(sink) {}

  void read() {
    skip_blanks();
    if (done()) fail(ErrorCode::kSyntax, "the path is empty");
    if (data_[at_] != 'M' && data_[at_] != 'm') fail(ErrorCode::kSyntax, "a path begins with M");
    while (!done()) {
      command_at_ = at_;
      char command = data_[at_++];
      arguments(command);
      skip_blanks();
    }
  }

 private:
  [[noreturn]] void fail(ErrorCode code, const std::string& message) const {
    throw Error(code, message, fmt::format("path, character {}", at_ + 1));
  }

  bool done() const { return at_ >= data_.size(); }

  void skip_blanks() {
    while (!done() && std::string_view(" \t\r\n\f").find(data_[at_]) != std::string_view::npos) ++at_;
  }

  /// Blanks with at most one comma.
  void skip_separator() {
    skip_blanks();
    if (!done() && data_[at_] == ',') {
      ++at_;
      skip_blanks();
    }
  }

  bool number_follows() {
    std::size_t back = at_;
    skip_separator();
    if (!done() && scan_number(data_.substr(at_)) > 0) return true;
    if (back != at_ && data_.substr(back, at_ - back).find(',') != std::string_view::npos) {
      fail(ErrorCode::kSyntax, "a number is missing behind the comma");
    }
    return false;
  }

  Real number(char command) {
    skip_separator();
    std::size_t length = scan_number(data_.substr(at_));
    if (length == 0) fail(ErrorCode::kSyntax, fmt::format("'{}' needs a number here", command));
    Real value = Real::parse_decimal(data_.substr(at_, length));
    at_ += length;
    return value;
  }

  bool flag() {
    skip_separator();
    if (done() || (data_[at_] != '0' && data_[at_] != '1')) fail(ErrorCode::kSyntax, "an arc's flag is 0 or 1");
    return data_[at_++] == '1';
  }

  void arguments(char command) {
    char upper = command >= 'a' ? static_cast<char>(command - 'a' + 'A') : command;
    bool relative = command != upper;
    if (std::string_view("MLHVACSQTZ").find(upper) == std::string_view::npos) {
      at_ = command_at_;
      fail(ErrorCode::kSyntax, fmt::format("'{}' is not a path command", command));
    }
    if (upper == 'Z') return close();
    do {
      one(upper, relative, command);
      before_ = upper;
      if (upper == 'M') upper = 'L';  // further points of a move are lines
    } while (number_follows());
  }

  void close() {
    tell([&] { sink_.close(); });
    x_ = start_x_;
    y_ = start_y_;
    before_ = 'Z';
  }

  void one(char upper, bool relative, char command) {
    if (upper == 'A') return arc(relative, command);
    if (std::string_view("CSQT").find(upper) != std::string_view::npos) return bezier(upper, relative, command);
    Real x = x_, y = y_;
    if (upper != 'V') x = relative ? x_ + number(command) : number(command);
    if (upper != 'H') y = relative ? y_ + number(command) : number(command);
    x_ = x;
    y_ = y;
    if (upper != 'M') return tell([&] { sink_.line_to(x_, y_); });
    start_x_ = x_;
    start_y_ = y_;
    tell([&] { sink_.move_to(x_, y_); });
  }

  void arc(bool relative, char command) {
    Real rx = abs(number(command)), ry = abs(number(command));
    const Real degrees = number(command);
    const Real from_x = x_, from_y = y_;
    bool large = flag(), sweep = flag();
    Real x = number(command), y = number(command);
    x_ = relative ? x_ + x : x;
    y_ = relative ? y_ + y : y;
    if (rx.sign() == 0 || ry.sign() == 0) return tell([&] { sink_.line_to(x_, y_); });
    if (compare(rx, ry) != 0) {
      if (from_x == x_ && from_y == y_) return;
      const EllipseArc ellipse =
          ellipse_arc({from_x.to_double(), from_y.to_double(), rx.to_double(), ry.to_double(),
                       exact::rounded_degrees(degrees), large, sweep, x_.to_double(), y_.to_double()});
      return tell([&] { sink_.ellipse_to(ellipse, x_, y_); });
    }
    tell([&] { sink_.arc_to(rx, large, sweep, x_, y_); });
  }

  /// The control point before the last end, reflected in it, where the command before was one of `kinds`.
  plane::CurvePoint reflected(std::string_view kinds) const {
    if (kinds.find(before_) == std::string_view::npos) return {x_, y_};
    return {x_ + x_ - control_.x, y_ + y_ - control_.y};
  }

  void bezier(char upper, bool relative, char command) {
    std::vector<plane::CurvePoint> points;
    if (upper == 'S') points.push_back(reflected("CS"));
    if (upper == 'T') points.push_back(reflected("QT"));
    const std::size_t count = upper == 'C' ? 3 : upper == 'Q' ? 2 : points.size() + (upper == 'S' ? 2 : 1);
    while (points.size() < count) {
      Real x = number(command), y = number(command);
      points.push_back(relative ? plane::CurvePoint{x_ + x, y_ + y} : plane::CurvePoint{std::move(x), std::move(y)});
    }
    control_ = points[points.size() - 2];
    x_ = points.back().x;
    y_ = points.back().y;
    tell([&] { sink_.curve_to(points); });
  }

  /// Errors of the sink get the place in the path.
  template <class Action>
  void tell(Action action) const {
    try {
      action();
    } catch (const Error& e) {
      throw e.within(fmt::format("path, character {}", at_ == 0 ? 1 : at_));
    }
  }

  std::string_view data_;
  PathSink& sink_;
  std::size_t at_ = 0, command_at_ = 0;
  Real x_, y_, start_x_, start_y_;
  plane::CurvePoint control_;  // of the last curve
  char before_ = ' ';          // the command before
};

}  // namespace

void read_svg_path(std::string_view data, PathSink& sink) { PathReader(data, sink).read(); }

}  // namespace findspace::io
