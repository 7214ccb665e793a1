// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/body/csg_solid.h"

#include <findspace/error.h>

#include <algorithm>
#include <numeric>

namespace findspace::space {

using exact::Real;
using exact::Refusal;
using exact::Tried;

namespace {

constexpr std::size_t kMostParts = 10000;

Body one(const BodyPart& part, std::int64_t scale = 1) {
  Body out;
  out.scale = scale;
  out.parts.push_back(part);
  return out;
}

/// `change` takes a body and returns it in other coordinates.
template <class Change>
CsgSolid changed(const CsgSolid& body, std::int64_t scale, Change&& change) {
  CsgSolid out;
  out.scale = scale;
  const auto set = [&](const BodyPart& part) { return change(one(part, body.scale)).parts[0]; };
  for (const CsgPart& part : body.parts) {
    CsgPart& made = out.parts.emplace_back();
    for (const BodyPart& p : part.within) made.within.push_back(set(p));
    for (const BodyPart& p : part.without) made.without.push_back(set(p));
  }
  for (const Body& tolerance : body.containers) out.containers.push_back(change(tolerance));
  for (const Body& obstacle : body.obstacles) out.obstacles.push_back(change(obstacle));
  return out;
}

bool meet(const Bounds3& a, const Bounds3& b) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (a.high[k] <= b.low[k] || b.high[k] <= a.low[k]) return false;
  }
  return true;
}

/// Whether a set whose boxes have this in common may have interior.
bool bulky(const Bounds3& box) {
  return box.low[0] < box.high[0] && box.low[1] < box.high[1] && box.low[2] < box.high[2];
}

/// Whether it may hold a place.
bool holds_places(const Bounds3& box) {
  return box.low[0] <= box.high[0] && box.low[1] <= box.high[1] && box.low[2] <= box.high[2];
}

Refusal too_many() { return Refusal("shapes cut by round ones into more than 10,000 parts are not computed"); }

/// False where there are too many already.
bool keep(CsgPart part, FlatParts flats, std::vector<CsgPart>& out) {
  const Bounds3 box = bounds(part);
  if (flats == FlatParts::kKept ? !holds_places(box) : !bulky(box)) return true;
  std::erase_if(part.without, [&](const BodyPart& o) { return !meet(bounds(one(o)), box); });
  if (out.size() == kMostParts) return false;
  out.push_back(std::move(part));
  return true;
}

std::pair<CsgSolid, CsgSolid> together(const CsgSolid& a, const CsgSolid& b) {
  const std::int64_t scale = std::lcm(a.scale, b.scale);
  return {at_scale(a, scale), at_scale(b, scale)};
}

/// x less y: where x leaves one of the sets that y lies within, or is in one that y lies without.
Tried<std::vector<CsgPart>> less(const std::vector<CsgPart>& all, const CsgPart& y, FlatParts flats) {
  std::vector<CsgPart> out;
  for (const CsgPart& x : all) {
    for (const BodyPart& p : y.within) {
      CsgPart part = x;
      part.without.push_back(p);
      if (!keep(std::move(part), flats, out)) return too_many();
    }
    for (const BodyPart& p : y.without) {
      CsgPart part = x;
      part.within.push_back(p);
      if (!keep(std::move(part), flats, out)) return too_many();
    }
  }
  return out;
}

Tried<std::vector<CsgPart>> less(std::vector<CsgPart> all, const std::vector<CsgPart>& others, FlatParts flats) {
  Tried<std::vector<CsgPart>> left = std::move(all);
  for (const CsgPart& y : others) {
    left = less(*left, y, flats);
    if (!left) break;
  }
  return left;
}

}  // namespace

CsgSolid uncut(Body body) {
  CsgSolid out;
  out.scale = body.scale;
  for (const BodyPart& part : body.parts) out.parts.push_back({{part}, {}});
  out.containers.push_back(std::move(body));
  return out;
}

CsgSolid united(const CsgSolid& first, const CsgSolid& second) {
  auto [a, b] = together(first, second);
  a.parts.insert(a.parts.end(), b.parts.begin(), b.parts.end());
  a.containers.clear();
  a.obstacles.clear();
  return std::move(a);
}

// The second form is kept where both have it.
Tried<CsgSolid> common(const CsgSolid& first, const CsgSolid& second, FlatParts flats) {
  const auto [a, b] = together(first, second);
  CsgSolid out;
  out.scale = a.scale;
  for (const CsgPart& x : a.parts) {
    for (const CsgPart& y : b.parts) {
      CsgPart part = x;
      part.within.insert(part.within.end(), y.within.begin(), y.within.end());
      part.without.insert(part.without.end(), y.without.begin(), y.without.end());
      if (!keep(std::move(part), flats, out.parts)) return too_many();
    }
  }
  if (a.containers.empty() || b.containers.empty()) return out;
  for (const CsgSolid* from : {&a, &b}) {
    out.containers.insert(out.containers.end(), from->containers.begin(), from->containers.end());
    out.obstacles.insert(out.obstacles.end(), from->obstacles.begin(), from->obstacles.end());
  }
  return out;
}

Tried<CsgSolid> less(const CsgSolid& first, const CsgSolid& second, FlatParts flats) {
  auto [a, b] = together(first, second);
  if (auto left = less(std::move(a.parts), b.parts, flats))
    a.parts = *std::move(left);
  else
    return left.refusal();
  const bool whole = b.containers.size() == 1 && b.obstacles.empty();
  if (whole && !a.containers.empty())
    a.obstacles.push_back(std::move(b.containers[0]));
  else {
    a.containers.clear();
    a.obstacles.clear();
  }
  return std::move(a);
}

CsgSolid without_flat_parts(CsgSolid body) {
  std::erase_if(body.parts, [](const CsgPart& part) { return !bulky(bounds(part)); });
  return body;
}

CsgSolid translated(const CsgSolid& body, const Point& by) {
  return changed(body, body.scale, [&](Body b) { return translated(std::move(b), by); });
}

CsgSolid mirrored(const CsgSolid& body) {
  return changed(body, body.scale, [](Body b) { return mirrored(std::move(b)); });
}

Tried<CsgSolid> left_in_box(const CsgSolid& body, const Point& low, const Point& high) {
  std::vector<Point> corners;
  for (int i = 0; i < 8; ++i)
    corners.push_back({i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
  CsgSolid out;
  out.scale = body.scale;
  out.parts.push_back({{part_of(corners, Real())}, {}});
  if (auto left = less(std::move(out.parts), body.parts, FlatParts::kDropped))
    out.parts = *std::move(left);
  else
    return left.refusal();
  return out;
}

CsgSolid at_scale(const CsgSolid& body, std::int64_t scale) {
  if (scale == body.scale) return body;
  return changed(body, scale, [&](const Body& b) { return at_scale(b, scale); });
}

Bounds3 bounds(const CsgPart& part) {
  Bounds3 box = bounds(one(part.within[0]));
  for (const BodyPart& p : part.within) {
    const Bounds3 next = bounds(one(p));
    for (std::size_t k = 0; k < 3; ++k) {
      box.low[k] = std::max(box.low[k], next.low[k]);
      box.high[k] = std::min(box.high[k], next.high[k]);
    }
  }
  return box;
}

Bounds3 bounds(const CsgSolid& body) {
  Bounds3 box = bounds(body.parts.at(0));
  for (const CsgPart& part : body.parts) {
    const Bounds3 next = bounds(part);
    for (std::size_t k = 0; k < 3; ++k) {
      box.low[k] = std::min(box.low[k], next.low[k]);
      box.high[k] = std::max(box.high[k], next.high[k]);
    }
  }
  return box;
}

}  // namespace findspace::space
