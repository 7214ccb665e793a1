// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/rays/ray_sources.h"

#include <algorithm>

namespace findspace::space {
namespace {

using Signs = std::span<const std::int8_t>;

bool any_searched(const std::vector<RaySourcePointer>& sources) {
  return std::any_of(sources.begin(), sources.end(), [](const RaySourcePointer& s) { return s->searched(); });
}

class Constant : public RaySource {
 public:
  Constant(const RayGrid& grid, int sign) : grid_(grid), sign_(static_cast<std::int8_t>(sign)) {}
  const RayGrid& grid() const override { return grid_; }
  exact::Tried<RayRow> try_row(int) const override {
    const auto lines = static_cast<std::size_t>(grid_.nu);
    return RayRow{std::vector<std::int8_t>(lines, sign_), std::vector<int>(lines + 1, 0), {}};
  }

 private:
  RayGrid grid_;
  std::int8_t sign_;
};

class Combined : public RaySource {
 public:
  /// `decides`: of a row that is the result whatever the sources after its own say; they are not asked then.
  Combined(std::vector<RaySourcePointer> sources, std::function<std::int8_t(Signs)> combine,
           std::function<bool(const RayRow&)> decides = {})
      : sources_(std::move(sources)), combine_(std::move(combine)), decides_(std::move(decides)) {}
  const RayGrid& grid() const override { return sources_[0]->grid(); }
  bool searched() const override { return any_searched(sources_); }
  exact::Tried<RayRow> try_row(int j) const override {
    std::vector<RayRow> rows;
    for (const RaySourcePointer& s : sources_) {
      exact::Tried<RayRow> row = s->try_row(j);
      if (!row || (decides_ && decides_(*row))) return row;
      rows.push_back(*std::move(row));
    }
    return combined(rows, combine_);
  }

 private:
  std::vector<RaySourcePointer> sources_;
  std::function<std::int8_t(Signs)> combine_;
  std::function<bool(const RayRow&)> decides_;
};

bool is_positive_everywhere(const RayRow& row) {
  return row.events.empty() && std::all_of(row.before.begin(), row.before.end(), [](std::int8_t s) { return s > 0; });
}

}  // namespace

RaySourcePointer constant_rays(const RayGrid& grid, int sign) { return std::make_unique<Constant>(grid, sign); }

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

RaySourcePointer greatest_rays(std::vector<RaySourcePointer> sources) {
  if (sources.size() == 1) return std::move(sources[0]);
  return std::make_unique<Combined>(
      std::move(sources), [](Signs s) { return *std::max_element(s.begin(), s.end()); }, is_positive_everywhere);
}

RaySourcePointer cut_off_rays(RaySourcePointer source, bool negated, const exact::Real& level) {
  const bool above = level.sign() > 0;
  return mapped_rays(std::move(source), [=](int s) {
    const int side = negated ? -s : s;
    return above ? side : side > 0 ? 1 : 0;
  });
}

}  // namespace findspace::space
