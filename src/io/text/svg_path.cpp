// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/text/svg_path.h"

#include <fmt/format.h>

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
    if (std::string_view("CSQT").find(upper) != std::string_view::npos) {
      at_ = command_at_;
      fail(ErrorCode::kUnsupported, fmt::format("'{}' is a Bezier curve; paths are made of M L H V A Z", command));
    }
    if (std::string_view("MLHVAZ").find(upper) == std::string_view::npos) {
      at_ = command_at_;
      fail(ErrorCode::kSyntax, fmt::format("'{}' is no path command", command));
    }
    if (upper == 'Z') return close();
    do {
      one(upper, relative, command);
      if (upper == 'M') upper = 'L';  // further points of a move are lines
    } while (number_follows());
  }

  void close() {
    tell([&] { sink_.close(); });
    x_ = start_x_;
    y_ = start_y_;
  }

  void one(char upper, bool relative, char command) {
    if (upper == 'A') return arc(relative, command);
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
    if (compare(rx, ry) != 0) fail(ErrorCode::kUnsupported, "an elliptical arc (rx and ry differ); arcs are circular");
    number(command);  // the rotation of an ellipse's axes means nothing for a circle
    bool large = flag(), sweep = flag();
    Real x = number(command), y = number(command);
    x_ = relative ? x_ + x : x;
    y_ = relative ? y_ + y : y;
    if (rx.sign() == 0) return tell([&] { sink_.line_to(x_, y_); });
    tell([&] { sink_.arc_to(rx, large, sweep, x_, y_); });
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
};

}  // namespace

void read_svg_path(std::string_view data, PathSink& sink) { PathReader(data, sink).read(); }

}  // namespace findspace::io
