// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/rays/ray_sources.h"

#include <algorithm>

#include "space/rays/row_merge.h"

namespace findspace::space {
namespace {

using Signs = std::span<const std::int8_t>;

bool any_searched(const std::vector<RaySourcePointer>& sources) {
  return std::any_of(sources.begin(), sources.end(), [](const RaySourcePointer& s) { return s->searched(); });
}

bool all_apart(const std::vector<RaySourcePointer>& sources, int j) {
  return std::all_of(sources.begin(), sources.end(), [j](const RaySourcePointer& s) { return s->apart(j); });
}

class Constant : public RaySource {
 public:
  Constant(const RayGrid& grid, int sign) : grid_(grid), sign_(sign) {}
  const RayGrid& grid() const override { return grid_; }
  exact::Tried<RayRow> try_row(int) const override { return constant_row(grid_, sign_); }
  bool apart(int) const override { return sign_ > 0; }

 private:
  RayGrid grid_;
  int sign_;
};

class Combined : public RaySource {
 public:
  Combined(std::vector<RaySourcePointer> sources, std::function<std::int8_t(Signs)> combine)
      : sources_(std::move(sources)),
        combine_(std::move(combine)),
        apart_with_all_(combine_(std::vector<std::int8_t>(sources_.size(), 1)) > 0) {}
  const RayGrid& grid() const override { return sources_[0]->grid(); }
  bool searched() const override { return any_searched(sources_); }
  bool apart(int j) const override { return apart_with_all_ && all_apart(sources_, j); }
  exact::Tried<RayRow> try_row(int j) const override {
    std::vector<RayRow> rows;
    for (const RaySourcePointer& s : sources_) {
      exact::Tried<RayRow> row = s->try_row(j);
      if (!row) return row;
      rows.push_back(*std::move(row));
    }
    return combined(rows, combine_);
  }

 private:
  std::vector<RaySourcePointer> sources_;
  std::function<std::int8_t(Signs)> combine_;
  bool apart_with_all_;
};

class Extreme : public RaySource {
 public:
  Extreme(std::vector<RaySourcePointer> sources, bool least) : sources_(std::move(sources)), least_(least) {}
  const RayGrid& grid() const override { return sources_[0]->grid(); }
  bool searched() const override { return any_searched(sources_); }
  bool apart(int j) const override { return least_ && all_apart(sources_, j); }
  exact::Tried<RayRow> try_row(int j) const override { return extreme_row(sources_, least_, j); }

 private:
  std::vector<RaySourcePointer> sources_;
  bool least_;
};

bool is_positive_everywhere(const RayRow& row) {
  return row.events.empty() && std::all_of(row.before.begin(), row.before.end(), [](std::int8_t s) { return s > 0; });
}

}  // namespace

RaySourcePointer constant_rays(const RayGrid& grid, int sign) { return std::make_unique<Constant>(grid, sign); }

RayRow constant_row(const RayGrid& grid, int sign) {
  const auto lines = static_cast<std::size_t>(grid.nu);
  return RayRow{std::vector<std::int8_t>(lines, static_cast<std::int8_t>(sign)), std::vector<int>(lines + 1, 0), {}};
}

RaySourcePointer combined_rays(std::vector<RaySourcePointer> sources, std::function<std::int8_t(Signs)> combine) {
  return std::make_unique<Combined>(std::move(sources), std::move(combine));
}

RaySourcePointer mapped_rays(RaySourcePointer source, std::function<int(int)> to) {
  std::vector<RaySourcePointer> one;
  one.push_back(std::move(source));
  return combined_rays(std::move(one), [to = std::move(to)](Signs s) { return static_cast<std::int8_t>(to(s[0])); });
}

RaySourcePointer negated_rays(RaySourcePointer source) {
  return mapped_rays(std::move(source), [](int s) { return -s; });
}

exact::Tried<RayRow> extreme_row(std::span<const RaySourcePointer> sources, bool least, int j) {
  if (sources.size() == 1) return sources[0]->try_row(j);
  std::vector<RayRow> rows;
  for (const RaySourcePointer& s : sources) {
    if (least && s->apart(j)) continue;
    exact::Tried<RayRow> row = s->try_row(j);
    // One that is + everywhere is the greatest, whatever those after it say: they are not asked.
    if (!row || (!least && is_positive_everywhere(*row))) return row;
    rows.push_back(*std::move(row));
  }
  return rows.empty() ? constant_row(sources[0]->grid(), 1) : extreme(rows, least);
}

RaySourcePointer greatest_rays(std::vector<RaySourcePointer> sources) {
  if (sources.size() == 1) return std::move(sources[0]);
  return std::make_unique<Extreme>(std::move(sources), false);
}

RaySourcePointer least_rays(std::vector<RaySourcePointer> sources) {
  if (sources.size() == 1) return std::move(sources[0]);
  return std::make_unique<Extreme>(std::move(sources), true);
}

RaySourcePointer cut_off_rays(RaySourcePointer source, bool negated, const exact::Real& level) {
  const bool above = level.sign() > 0;
  return mapped_rays(std::move(source), [=](int s) {
    const int side = negated ? -s : s;
    return above ? side : side > 0 ? 1 : 0;
  });
}

}  // namespace findspace::space
