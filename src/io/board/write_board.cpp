// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/board/write_board.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "formula/language/text.h"
#include "io/board/board_pad.h"
#include "io/board/read_board.h"

namespace findspace::io {
namespace {

using exact::Real;

struct Change {
  std::size_t begin, end;
  std::string text;
};

/// Millionths of a millimetre as millimetres: "12.5".
std::string millimetres(std::int64_t steps) {
  std::string out =
      fmt::format("{}{}.{:06}", steps < 0 ? "-" : "", std::abs(steps) / 1000000, std::abs(steps) % 1000000);
  while (out.back() == '0') out.pop_back();
  if (out.back() == '.') out.pop_back();
  return out;
}

/// In (-180, 180], as KiCad writes angles.
std::string degrees_text(Real degrees) {
  degrees = degrees - Real(360) * Real(floor(degrees / Real(360)));
  if (Real(180) < degrees) degrees = degrees - Real(360);
  return formula::decimal_text(degrees);
}

/// Where the point (x, y), in millionths of a millimetre from the anchor, comes to stand.
plane::GridPoint moved(const Real& x, const Real& y, const NewPlace& place) {
  const Direction d = direction(-place.turn);  // y runs downwards
  const auto nearest = [](const Real& value) { return static_cast<std::int64_t>(floor(value + Real::ratio(1, 2))); };
  return {place.at.x + nearest(d.cosine * x - d.sine * y), place.at.y + nearest(d.sine * x + d.cosine * y)};
}

class Mover {
 public:
  explicit Mover(std::vector<Change>& changes) : changes_(changes) {}

  void move(const Sexpr& footprint, const NewPlace& place) {
    const Sexpr at = footprint.need("at");
    footprint.each([&](const Sexpr& item) {
      if (item.is("zone")) move_points(item, at, place);
    });
    replace(at.item(0), millimetres(place.at.x));
    replace(at.item(1), millimetres(place.at.y));
    if (place.turn.sign() == 0) return;
    turn(at, place.turn);
    footprint.each([&](const Sexpr& item) {
      if (!item.is("pad") && !item.is("fp_text") && !item.is("property")) return;
      if (const auto own = item.find("at")) turn(*own, place.turn);
    });
  }

 private:
  void replace(const Sexpr& word, std::string text) { changes_.push_back({word.begin(), word.end(), std::move(text)}); }

  /// The points of an area, which stand in the board's coordinates.
  void move_points(const Sexpr& list, const Sexpr& anchor, const NewPlace& place) {
    const auto from_anchor = [&](const Sexpr& point, std::size_t k) {
      return Real(1000000) * (point.item(k).number() - anchor.item(k).number());
    };
    list.each([&](const Sexpr& item) {
      if (!item.is_list()) return;
      if (!item.is("xy") && !item.is("start") && !item.is("mid") && !item.is("end"))
        return move_points(item, anchor, place);
      const plane::GridPoint to = moved(from_anchor(item, 0), from_anchor(item, 1), place);
      replace(item.item(0), millimetres(to.x));
      replace(item.item(1), millimetres(to.y));
    });
  }

  void turn(const Sexpr& at, const Real& by) {
    const std::vector<Sexpr> items = at.items();
    const std::string text = degrees_text(angle_of(at) + by);
    for (std::size_t k = 2; k < items.size(); ++k)
      if (!items[k].is_list() && items[k].text() != "unlocked") return replace(items[k], text);
    changes_.push_back({items[1].end(), items[1].end(), " " + text});
  }

  std::vector<Change>& changes_;
};

}  // namespace

NewPlace place_beside(const Part& part, const Part& first, const NewPlace& place) {
  return {moved(Real(part.at.x - first.at.x), Real(part.at.y - first.at.y), place), place.turn};
}

std::string moved_board(std::string_view text, const std::string& file, const std::map<std::string, NewPlace>& places) {
  const SexprTree tree(text, file);
  std::vector<Sexpr> footprints;
  tree.root().each([&](const Sexpr& item) {
    if (is_footprint(item)) footprints.push_back(item);
  });
  const std::vector<std::string> names = part_names(footprints);
  std::vector<Change> changes;
  std::size_t found = 0;
  for (std::size_t k = 0; k < footprints.size(); ++k) {
    const auto place = places.find(names[k]);
    if (place == places.end()) continue;
    Mover(changes).move(footprints[k], place->second);
    ++found;
  }
  if (found < places.size()) throw Error(ErrorCode::kUnknownName, "a part that is to be moved is none", file);
  // Within a footprint (at ...) may stand after its pads.
  std::stable_sort(changes.begin(), changes.end(), [](const Change& a, const Change& b) { return a.begin < b.begin; });
  std::string out;
  std::size_t done = 0;
  for (const Change& c : changes) {
    out.append(text.substr(done, c.begin - done)).append(c.text);
    done = c.end;
  }
  return out.append(text.substr(done));
}

}  // namespace findspace::io
