// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/body/cut_body.h"

#include <findspace/error.h>

#include <algorithm>
#include <numeric>

namespace findspace::space {

using exact::Real;

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
CutBody changed(const CutBody& body, std::int64_t scale, Change&& change) {
  CutBody out;
  out.scale = scale;
  const auto set = [&](const BodyPart& part) { return change(one(part, body.scale)).parts[0]; };
  for (const CutPart& part : body.parts) {
    CutPart& made = out.parts.emplace_back();
    for (const BodyPart& p : part.within) made.within.push_back(set(p));
    for (const BodyPart& p : part.without) made.without.push_back(set(p));
  }
  for (const Body& room : body.rooms) out.rooms.push_back(change(room));
  for (const Body& pillar : body.pillars) out.pillars.push_back(change(pillar));
  return out;
}

bool meet(const Bounds3& a, const Bounds3& b) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (a.high[k] <= b.low[k] || b.high[k] <= a.low[k]) return false;
  }
  return true;
}

/// Whether a set whose boxes are these may have interior.
bool bulky(const CutPart& part) {
  const Bounds3 box = bounds(part);
  return box.low[0] < box.high[0] && box.low[1] < box.high[1] && box.low[2] < box.high[2];
}

void keep(CutPart part, std::vector<CutPart>& out) {
  if (!bulky(part)) return;
  const Bounds3 box = bounds(part);
  std::erase_if(part.without, [&](const BodyPart& o) { return !meet(bounds(one(o)), box); });
  if (out.size() == kMostParts)
    throw Error(ErrorCode::kUnsupported, "shapes cut by round ones into more than 10,000 parts are not computed");
  out.push_back(std::move(part));
}

std::pair<CutBody, CutBody> together(const CutBody& a, const CutBody& b) {
  const std::int64_t scale = std::lcm(a.scale, b.scale);
  return {at_scale(a, scale), at_scale(b, scale)};
}

/// x less y: where x leaves one of the sets that y lies within, or is in one that y lies without.
std::vector<CutPart> less(const std::vector<CutPart>& all, const CutPart& y) {
  std::vector<CutPart> out;
  for (const CutPart& x : all) {
    for (const BodyPart& p : y.within) {
      CutPart part = x;
      part.without.push_back(p);
      keep(std::move(part), out);
    }
    for (const BodyPart& p : y.without) {
      CutPart part = x;
      part.within.push_back(p);
      keep(std::move(part), out);
    }
  }
  return out;
}

}  // namespace

CutBody uncut(Body body) {
  CutBody out;
  out.scale = body.scale;
  for (const BodyPart& part : body.parts) out.parts.push_back({{part}, {}});
  out.rooms.push_back(std::move(body));
  return out;
}

CutBody united(const CutBody& first, const CutBody& second) {
  auto [a, b] = together(first, second);
  a.parts.insert(a.parts.end(), b.parts.begin(), b.parts.end());
  a.rooms.clear(), a.pillars.clear();
  return std::move(a);
}

// The second form is kept where both have it.
CutBody common(const CutBody& first, const CutBody& second) {
  const auto [a, b] = together(first, second);
  CutBody out;
  out.scale = a.scale;
  for (const CutPart& x : a.parts) {
    for (const CutPart& y : b.parts) {
      CutPart part = x;
      part.within.insert(part.within.end(), y.within.begin(), y.within.end());
      part.without.insert(part.without.end(), y.without.begin(), y.without.end());
      keep(std::move(part), out.parts);
    }
  }
  if (a.rooms.empty() || b.rooms.empty()) return out;
  for (const CutBody* from : {&a, &b}) {
    out.rooms.insert(out.rooms.end(), from->rooms.begin(), from->rooms.end());
    out.pillars.insert(out.pillars.end(), from->pillars.begin(), from->pillars.end());
  }
  return out;
}

CutBody less(const CutBody& first, const CutBody& second) {
  auto [a, b] = together(first, second);
  for (const CutPart& part : b.parts) a.parts = less(a.parts, part);
  const bool whole = b.rooms.size() == 1 && b.pillars.empty();
  if (whole && !a.rooms.empty())
    a.pillars.push_back(std::move(b.rooms[0]));
  else
    a.rooms.clear(), a.pillars.clear();
  return std::move(a);
}

CutBody translated(const CutBody& body, const Point& by) {
  return changed(body, body.scale, [&](Body b) { return translated(std::move(b), by); });
}

CutBody mirrored(const CutBody& body) {
  return changed(body, body.scale, [](Body b) { return mirrored(std::move(b)); });
}

CutBody left_in_box(const CutBody& body, const Point& low, const Point& high) {
  std::vector<Point> corners;
  for (int i = 0; i < 8; ++i)
    corners.push_back({i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
  CutBody out;
  out.scale = body.scale;
  out.parts.push_back({{part_of(corners, Real())}, {}});
  for (const CutPart& part : body.parts) out.parts = less(out.parts, part);
  return out;
}

CutBody at_scale(const CutBody& body, std::int64_t scale) {
  if (scale == body.scale) return body;
  return changed(body, scale, [&](const Body& b) { return at_scale(b, scale); });
}

Bounds3 bounds(const CutPart& part) {
  Bounds3 box = bounds(one(part.within[0]));
  for (const BodyPart& p : part.within) {
    const Bounds3 next = bounds(one(p));
    for (std::size_t k = 0; k < 3; ++k)
      box.low[k] = std::max(box.low[k], next.low[k]), box.high[k] = std::min(box.high[k], next.high[k]);
  }
  return box;
}

Bounds3 bounds(const CutBody& body) {
  Bounds3 box = bounds(body.parts.at(0));
  for (const CutPart& part : body.parts) {
    const Bounds3 next = bounds(part);
    for (std::size_t k = 0; k < 3; ++k)
      box.low[k] = std::min(box.low[k], next.low[k]), box.high[k] = std::max(box.high[k], next.high[k]);
  }
  return box;
}

}  // namespace findspace::space
