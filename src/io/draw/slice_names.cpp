// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/draw/slice_names.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "io/draw/draw_labels.h"
#include "io/draw/draw_layout.h"

namespace findspace::io {
namespace {

using plane::Bounds;
using plane::Place;

constexpr double kSliceFont = 10, kCell = 3, kOffSection = 4;  // pixels
constexpr int kNobody = -1;
// What a cell under a name counts, by what is there.
constexpr double kEmptyCell = 0.4, kRegionCell = 1, kRegionOnOwnCell = 0.5, kOtherCell = 2;
constexpr double kUpwards = 0.3;
constexpr double kRoom = 0.75;  // of a name that lies on its section, at least

/// What is seen in each cell of a panel.
class SliceCells {
 public:
  explicit SliceCells(const Frame& frame)
      : frame_(frame),
        columns_(static_cast<int>(std::ceil(frame.width() / kCell))),
        rows_(static_cast<int>(std::ceil(frame.height() / kCell))),
        seen_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), kNobody),
        region_(seen_.size()) {}

  /// The cells whose middles lie in a strip.
  template <class Visit>
  void each(const Strip& strip, double width, Visit visit) const {
    const auto range = [](double from, double to, int n) {
      return std::pair{std::max(0, static_cast<int>(std::ceil(from / kCell - 0.5))),
                       std::min(n, static_cast<int>(std::ceil(to / kCell - 0.5)))};
    };
    const auto [x0, x1] = range(frame_.x(strip.from) - frame_.left, frame_.x(strip.to) - frame_.left, columns_);
    const auto [y0, y1] =
        range(frame_.y(strip.y + width / 2) - frame_.top, frame_.y(strip.y - width / 2) - frame_.top, rows_);
    for (int y = y0; y < y1; ++y)
      for (int x = x0; x < x1; ++x) visit(x, y);
  }
  void put(const std::vector<Strip>& strips, double width, int what) {
    for (const Strip& s : strips) each(s, width, [&](int x, int y) { seen_[index(x, y)] = what; });
  }
  /// The region lies on the sections and lets them be seen.
  void put_region(const std::vector<Strip>& strips, double width) {
    for (const Strip& s : strips) each(s, width, [&](int x, int y) { region_[index(x, y)] = true; });
  }
  Place middle(int x, int y) const { return {frame_.left + (x + 0.5) * kCell, frame_.top + (y + 0.5) * kCell}; }

  struct Under {
    double own, cost;  // parts and mean of the cells under a box
  };
  Under under(const Bounds& box, int own) const {
    const auto cell = [&](double p, double from, int n) {
      return std::clamp(static_cast<int>(std::floor((p - from) / kCell)), 0, n - 1);
    };
    const int x0 = cell(box.low[0], frame_.left, columns_), x1 = cell(box.high[0], frame_.left, columns_);
    const int y0 = cell(box.low[1], frame_.top, rows_), y1 = cell(box.high[1], frame_.top, rows_);
    double mine = 0, cost = 0, all = 0;
    for (int y = y0; y <= y1; ++y)
      for (int x = x0; x <= x1; ++x) {
        const int what = seen_[index(x, y)];
        ++all;
        const bool covered = region_[index(x, y)];
        mine += what == own ? 1 : 0;
        if (what == own)
          cost += covered ? kRegionOnOwnCell : 0;
        else
          cost += covered ? kRegionCell : what == kNobody ? kEmptyCell : kOtherCell;
      }
    return {mine / all, cost / all};
  }
  bool within(const Bounds& box) const {
    return frame_.left <= box.low[0] && box.high[0] <= frame_.left + frame_.width() && frame_.top <= box.low[1] &&
           box.high[1] <= frame_.top + frame_.height();
  }
  bool is(int x, int y, int what) const { return seen_[index(x, y)] == what; }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x);
  }

  const Frame& frame_;
  int columns_, rows_;
  std::vector<int> seen_;
  std::vector<bool> region_;
};

struct SlicePlace {
  Place at;
  bool upwards;
  double own, cost;
};

/// The names of one layer.
class SliceLabels {
 public:
  explicit SliceLabels(const SliceLayer& layer) : layer_(layer), cells_(layer.frame) {
    for (const SliceSection& s : layer.sections) cells_.put(s.strips, layer.width, static_cast<int>(s.shape));
    cells_.put_region(layer.region, layer.width);
  }

  /// The best place for the name of a section; none where there is none.
  std::optional<SlicePlace> place(const SliceSection& section, const std::string& name) {
    best_.reset();
    const int own = static_cast<int>(section.shape);
    std::optional<Bounds> box;  // of what is seen of it
    for (const Strip& s : section.strips)
      cells_.each(s, layer_.width, [&](int x, int y) {
        if (!cells_.is(x, y, own)) return;
        const Place p = cells_.middle(x, y);
        include(box, {p, p});
        if (x % 2 == 0 && y % 2 == 0)
          for (const bool upwards : {false, true}) consider(name, p, upwards, own, true);
      });
    if (!box) return std::nullopt;
    if (!best_ && !fills(*box)) beside(name, *box, own);
    return best_;
  }
  void put(const std::string& name, const SlicePlace& p) {
    taken_.push_back(box_of_text(p.at, name, p.upwards));
    out_ += label_text(p.at[0], p.at[1], name, kSliceFont, p.upwards);
  }
  /// Whether it goes through most of the panel both ways.
  bool fills(const Bounds& box) const {
    constexpr double kMost = 0.7;
    return box.high[0] - box.low[0] > kMost * layer_.frame.width() &&
           box.high[1] - box.low[1] > kMost * layer_.frame.height();
  }
  std::optional<Bounds> extent(const SliceSection& section) const {
    std::optional<Bounds> box;
    for (const Strip& s : section.strips)
      include(box, {{layer_.frame.x(s.from), layer_.frame.y(s.y)}, {layer_.frame.x(s.to), layer_.frame.y(s.y)}});
    return box;
  }
  const std::string& svg() const { return out_; }

 private:
  static Bounds box_of_text(const Place& at, const std::string& name, bool upwards) {
    const Bounds b = text_box(at, name, kSliceFont);
    if (!upwards) return b;
    const double w = at[0] - b.low[0], h = at[1] - b.low[1];
    return {{at[0] - h, at[1] - w}, {at[0] + h, at[1] + w}};
  }
  void consider(const std::string& name, const Place& at, bool upwards, int own, bool on) {
    const Bounds text = box_of_text(at, name, upwards);
    if (!cells_.within(text)) return;
    if (std::any_of(taken_.begin(), taken_.end(), [&](const Bounds& t) { return boxes_meet(t, text); })) return;
    const SliceCells::Under under = cells_.under(text, own);
    if (on && under.own < kRoom) return;
    const double cost = under.cost + (upwards ? kUpwards : 0);
    if (!best_ || cost < best_->cost) best_ = SlicePlace{at, upwards, under.own, cost};
  }
  void beside(const std::string& name, const Bounds& box, int own) {
    const double w = text_width(name, kSliceFont) / 2 + kOffSection, h = kSliceFont * 0.6 + kOffSection;
    const double x = (box.low[0] + box.high[0]) / 2, y = (box.low[1] + box.high[1]) / 2;
    const double left = box.low[0], right = box.high[0];
    if (box.high[1] - box.low[1] > 2 * w) {  // a name along it says best what is meant
      for (const double at : {left - h, right + h}) consider(name, {at, y}, true, own, false);
      if (best_) return;
    }
    for (const double dx : {0.0, -0.7, 0.7})
      for (const double at : {box.low[1] - h, box.high[1] + h}) consider(name, {x + dx * w, at}, false, own, false);
    for (const double dy : {0.0, -1.0, 1.0})
      for (const double at : {right + w, left - w}) consider(name, {at, y + dy * h}, false, own, false);
    if (!best_) consider(name, {x, y}, false, own, false);
  }

  const SliceLayer& layer_;
  SliceCells cells_;
  std::vector<Bounds> taken_;
  std::optional<SlicePlace> best_;
  std::string out_;
};

/// Where one shape stands best among all layers.
struct BestLayer {
  std::size_t layer;
  const SliceSection* section;
  double cost;
};

}  // namespace

std::vector<std::string> slice_names(const std::vector<SliceLayer>& layers, const std::vector<std::string>& names) {
  std::vector<SliceLabels> labels;
  for (const SliceLayer& layer : layers) labels.emplace_back(layer);
  std::vector<std::optional<BestLayer>> filling(names.size());
  for (std::size_t k = 0; k < layers.size(); ++k) {
    const auto& sections = layers[k].sections;
    for (auto s = sections.rbegin(); s != sections.rend(); ++s) {
      const auto box = labels[k].extent(*s);
      if (!box) continue;
      const auto place = labels[k].place(*s, names[s->shape]);
      if (!place) continue;
      auto& best = filling[s->shape];
      if (!labels[k].fills(*box))
        labels[k].put(names[s->shape], *place);
      else if (!best || place->cost < best->cost)
        best = BestLayer{k, &*s, place->cost};
    }
  }
  for (std::size_t n = 0; n < names.size(); ++n) {
    if (!filling[n]) continue;
    SliceLabels& in = labels[filling[n]->layer];
    if (const auto place = in.place(*filling[n]->section, names[n])) in.put(names[n], *place);
  }
  std::vector<std::string> out;
  for (const SliceLabels& l : labels) out.push_back(l.svg());
  return out;
}

}  // namespace findspace::io
