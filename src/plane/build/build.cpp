// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/build/build.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <numeric>
#include <set>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "exact/margins/plane.h"
#include "exact/number/real_size.h"
#include "findspace/error.h"
#include "plane/base/result_store.h"
#include "plane/build/hull.h"
#include "plane/complex/cell_bytes.h"
#include "plane/complex/extent.h"
#include "plane/complex/overlay.h"
#include "plane/complex/primitives.h"
#include "plane/complex/side_by_side.h"
#include "plane/offset/plain_sum.h"
#include "plane/query/topology.h"
#include "plane/sum/minkowski.h"
#include "plane/walk/unite.h"

namespace findspace::plane {
namespace {

using Kind = Shape::Kind;
using RegionPtr = std::shared_ptr<const Region>;

bool is_boolean(Kind kind) {
  return kind == Kind::kUnion || kind == Kind::kIntersection || kind == Kind::kDifference || kind == Kind::kComplement;
}

/// Operands of one overlay at most: an overlay keeps a mark of every operand for every cell.
constexpr std::size_t kOperands = 32;

/// Units of work (plane/base/work_budget.h).
constexpr std::uint64_t kCell = 20, kPair = 20, kCopied = 8;

/// Bits of a sign about a sum for a unit of work. Few signs need as many as they may.
constexpr double kBitsOfSign = 128;

/// The coordinate of a vertex about which a sign may take the most bits.
exact::Real longest_number(const Region& r) {
  exact::Real longest;
  double most = 0;
  for (const Vertex& v : r.vertices) {
    if (r.geometry.points[v.point].kind == exact::Point::Kind::kGrid) continue;
    const exact::RealPoint at = r.geometry.exact(v.point);
    for (const exact::Real& number : {at.x, at.y}) {
      const double bits = exact::sign_bits(number);
      if (bits <= most) continue;
      most = bits;
      longest = number;
    }
  }
  return longest;
}

/// Edges, and points by themselves.
std::uint64_t parts(const Region& r) {
  const auto more = [](std::uint64_t sum, const Face& f) { return sum + f.isolated.size(); };
  return std::accumulate(r.faces.begin(), r.faces.end(), std::uint64_t(r.edges.size()), more);
}

bool has_arcs(const Region& r) {
  return std::any_of(r.edges.begin(), r.edges.end(), [](const Edge& e) { return e.half != 0; });
}

bool is_sum(Kind kind) { return kind == Kind::kMinkowskiSum || kind == Kind::kMinkowskiDifference; }

/// What can have more edges than its operands, and reach farther.
bool is_construction(Kind kind) { return is_sum(kind) || kind == Kind::kOffset; }

void check_reach(const Region& made) {
  if (!is_within(made, margin::kFarthestVertex))
    throw Error(ErrorCode::kOutOfRange,
                "a sum, a difference or an offset leaves the grid: a coordinate exceeds 2^42 grid steps");
}

/// A Boolean tree over the regions it was compiled with.
struct Expression {
  Kind kind = Kind::kUnion;
  Index leaf = kNone;  // not kNone: the mark of this operand
  std::vector<Expression> children;

  bool holds(std::span<const Mark> marks) const {
    if (leaf != kNone) return marks[leaf] > 0;
    auto inside = [&](const Expression& e) { return e.holds(marks); };
    switch (kind) {
      case Kind::kUnion:
        return std::any_of(children.begin(), children.end(), inside);
      case Kind::kIntersection:
        return std::all_of(children.begin(), children.end(), inside);
      case Kind::kDifference:
        return inside(children[0]) && std::none_of(children.begin() + 1, children.end(), inside);
      default:
        return !inside(children[0]);
    }
  }
};

class Builder {
 public:
  Builder(const Shape& root, double step, std::uint64_t work) : step_(step), work_(work) { count_uses(root); }

  Region make(const Shape& shape) {
    try {
      Region made = is_boolean(shape.kind) ? combine(shape) : leaf(shape);
      if (is_construction(shape.kind)) check_reach(made);
      return made;
    } catch (const Error& e) {
      if (!e.place().empty()) throw;
      throw e.within(shape.place.empty() ? shape.name : shape.place);
    }
  }

  Rounding rounding;

 private:
  /// Of children that nothing else holds, which are most of many, no count is kept: it is 1.
  void count_uses(const Shape& shape) {
    for (const ShapePtr& child : shape.children) {
      if (child.use_count() == 1 || uses_[child.get()]++ == 0) count_uses(*child);
    }
  }

  bool occurs_once(const Shape& shape) const {
    const auto known = uses_.find(&shape);
    return known == uses_.end() || known->second == 1;
  }

  RegionPtr region(const Shape& shape) {
    if (auto known = built_.find(&shape); known != built_.end()) return known->second;
    auto made = std::make_shared<const Region>(make(shape));
    if (is_construction(shape.kind)) work_.charge(kCell * parts(*made), "a construction of so many edges");
    if (has_copy(shape)) work_.charge(kCopied * parts(*made), "a shape of so many copied edges");
    return built_[&shape] = std::move(made);
  }

  /// Whether a child stands elsewhere as well: a few names of shapes can stand for very many edges.
  bool has_copy(const Shape& shape) const {
    return std::any_of(shape.children.begin(), shape.children.end(),
                       [&](const ShapePtr& child) { return !occurs_once(*child); });
  }

  /// The operands of the shape, those of a union within a union (or intersections) in place of it, if it occurs once.
  std::vector<const Shape*> operands_of(const Shape& shape) {
    std::vector<const Shape*> out, todo;
    out.reserve(shape.children.size());
    const bool joins = shape.kind == Kind::kUnion || shape.kind == Kind::kIntersection;
    const auto put_off = [&](const Shape& of) {
      for (auto child = of.children.rbegin(); child != of.children.rend(); ++child) todo.push_back(child->get());
    };
    for (put_off(shape); !todo.empty();) {
      const Shape& at = *todo.back();
      todo.pop_back();
      if (joins && at.kind == shape.kind && occurs_once(at))
        put_off(at);
      else
        out.push_back(&at);
    }
    return out;
  }

  Region combine(const Shape& shape) {
    const std::vector<const Shape*> operands = operands_of(shape);
    const bool sets_alone =
        std::none_of(operands.begin(), operands.end(), [&](const Shape* s) { return width(*s) > 1; });
    if (operands.size() > kOperands || (shape.kind == Kind::kUnion && sets_alone)) return of_many(shape.kind, operands);
    std::vector<RegionPtr> leaves;
    Expression expression = compile(shape, leaves);
    return evaluate(expression, leaves);
  }

  static Region evaluate(const Expression& expression, const std::vector<RegionPtr>& leaves) {
    std::vector<const Region*> operands;
    for (const RegionPtr& leaf : leaves) operands.push_back(leaf.get());
    return overlay(operands, [&](std::span<const Mark> marks) { return Mark(expression.holds(marks)); });
  }

  static Expression operand(RegionPtr region, std::vector<RegionPtr>& leaves) {
    auto place = std::find(leaves.begin(), leaves.end(), region);
    Index leaf = Index(place - leaves.begin());
    if (place == leaves.end()) leaves.push_back(std::move(region));
    return {.kind = Kind::kUnion, .leaf = leaf, .children = {}};
  }

  /// Operands the shape adds to an overlay when its Boolean nodes are evaluated there: those that occur once, and few
  /// enough.
  std::size_t width(const Shape& shape) {
    if (!is_boolean(shape.kind) || !occurs_once(shape) || shape.children.size() > kOperands) return 1;
    std::size_t known = width_[&shape];
    if (known > 0) return known;
    std::size_t sum = 0;
    for (const ShapePtr& child : shape.children) sum += width(*child);
    return width_[&shape] = sum > kOperands ? 1 : sum;
  }

  Expression compile(const Shape& shape, std::vector<RegionPtr>& leaves) {
    Expression node{.kind = shape.kind, .leaf = kNone, .children = {}};
    for (const ShapePtr& child : shape.children) {
      bool inlined = width(*child) > 1 && leaves.size() + width(*child) <= kOperands;
      node.children.push_back(inlined ? compile(*child, leaves) : operand(region(*child), leaves));
    }
    return node;
  }

  /// A union, intersection or difference of many operands. What is subtracted from the first operand of a difference
  /// is the union of the others.
  Region of_many(Kind kind, const std::vector<const Shape*>& operands) {
    if (kind == Kind::kIntersection) return *in_groups(regions(operands), intersect);
    if (kind == Kind::kUnion) return united(operands);
    const Region others = united(std::span(operands).subspan(1));
    RegionPtr first = region(*operands[0]);
    return subtract(std::vector<const Region*>{first.get(), &others});
  }

  std::vector<RegionPtr> regions(std::span<const Shape* const> shapes) {
    std::vector<RegionPtr> out;
    for (const Shape* shape : shapes) out.push_back(region(*shape));
    return out;
  }

  /// Only operands whose boxes meet are united by arranging them.
  Region united(std::span<const Shape* const> operands) {
    std::vector<const Shape*> kept;
    std::vector<PieceBox> boxes;
    kept.reserve(operands.size());
    boxes.reserve(operands.size());
    for (const Shape* shape : operands) {
      const RegionPtr made = only_rings(*shape) ? nullptr : region(*shape);
      if (made && made->faces[0].mark != 0) return *in_groups(regions(operands), unite);  // not bounded
      const auto box = made ? extent(*made) : extent(shape->contours);
      if (!box) continue;  // the empty set
      boxes.push_back(*box);
      kept.push_back(shape);
    }
    return kept.empty() ? Region::uniform(0) : united_groups(kept, groups_apart(boxes));
  }

  /// Rings that stand alone are made together, and never one by one.
  Region united_groups(std::span<const Shape* const> operands, const IndexGroups& groups) {
    std::vector<RegionPtr> parts;
    std::vector<std::span<const Contour>> alone;
    alone.reserve(groups.size());
    const auto make_alone = [&] {
      if (!alone.empty()) parts.push_back(std::make_shared<const Region>(region_of_polygons(alone)));
      alone.clear();
    };
    for (std::size_t g = 0; g < groups.size(); ++g) {
      const std::span<const Index> group = groups[g];
      if (group.size() == 1 && only_rings(*operands[group[0]])) {
        alone.emplace_back(operands[group[0]]->contours);
        continue;
      }
      make_alone();
      std::vector<const Shape*> members;
      for (const Index k : group) members.push_back(operands[k]);
      parts.push_back(united_group(members));
    }
    if (parts.empty()) return region_of_polygons(alone);
    make_alone();
    if (parts.size() == 1) return *parts[0];
    std::vector<const Region*> all;
    for (const RegionPtr& part : parts) all.push_back(part.get());
    return side_by_side(all);
  }

  /// Of sets whose boxes meet.
  RegionPtr united_group(const std::vector<const Shape*>& members) {
    std::vector<std::span<const Contour>> rings;
    for (const Shape* shape : members)
      if (only_rings(*shape)) rings.emplace_back(shape->contours);
    if (rings.size() == members.size())
      if (auto united = united_by_walks(rings)) return std::make_shared<const Region>(*std::move(united));
    return in_groups(regions(members), unite);
  }

  /// Nothing else needs its region.
  bool only_rings(const Shape& shape) const { return shape.kind == Kind::kRings && occurs_once(shape); }

  static RegionPtr in_groups(std::vector<RegionPtr> level, Region (*join)(std::span<const Region* const>)) {
    while (level.size() > 1) {
      std::vector<RegionPtr> next;
      for (std::size_t k = 0; k < level.size(); k += kOperands) {
        std::vector<const Region*> group;
        for (std::size_t i = k; i < std::min(k + kOperands, level.size()); ++i) group.push_back(level[i].get());
        next.push_back(std::make_shared<const Region>(join(group)));
      }
      level = std::move(next);
    }
    return level[0];
  }

  Region leaf(const Shape& s) {
    switch (s.kind) {
      case Kind::kRings:
        return region_of_rings(s.contours);
      case Kind::kDisc:
        return region_of_disc(s.points[0].x, s.points[0].y, s.amount);
      case Kind::kPoints:
        return region_of_points(s.points);
      case Kind::kPolyline:
        return region_of_chain(s.contours[0]);
      case Kind::kCells:
        return *s.cells;
      case Kind::kInterior:
        return interior(*child(s, 0));
      case Kind::kClosure:
        return closure(*child(s, 0));
      case Kind::kBoundary:
        return boundary(*child(s, 0));
      case Kind::kRegularize:
        return regularize(*child(s, 0));
      case Kind::kTranslate:
        return translated(*child(s, 0), s.points[0]);
      case Kind::kRotate:
        return rotated(*child(s, 0), s.points[0], s.degrees, step_, rounding);
      case Kind::kMirror:
        return mirrored(*child(s, 0));
      case Kind::kMinkowskiSum:
        charge_pairs(s);
        return plain_sum(*child(s, 0), *child(s, 1));
      case Kind::kMinkowskiDifference:
        charge_pairs(s);
        return plain_difference(*child(s, 0), *child(s, 1));
      case Kind::kOffset:
        charge_offset(s);
        return plain_offset(*child(s, 0), s.amount);
      case Kind::kHull:
        return hull_of(s);
      default:
        return combine(s);
    }
  }

  /// A sum looks at the edges of one operand with those of the other. Its places are sums of theirs, with the roots of
  /// both: deciding about the longest ones may take as many bits as these have together.
  void charge_pairs(const Shape& s) {
    const RegionPtr a = child(s, 0), b = child(s, 1);
    work_.charge(kPair * parts(*a) * parts(*b), "a Minkowski sum or difference of so many edges");
    const double units = exact::sign_bits(longest_number(*a) + longest_number(*b)) / kBitsOfSign;
    work_.charge(std::uint64_t(std::min(units, 1e18)), "a Minkowski sum or difference of sums with so many roots");
    if (offsets(s).depth > 0) charge_levels(s, a->edges.size() + b->edges.size(), "a sum of sums of so many arcs");
  }

  /// Numbers of an offset of an offset are sums of roots: each level about triples what it costs to decide about them.
  /// A boundary between two offsets counts as a level, as curves of both its sides meet. An offset above such a
  /// boundary counts twice if its amount is not used below it: what moves there and back is not where it was.
  void charge_offset(const Shape& s) {
    charge_levels(s, child(s, 0)->edges.size() + 1, "an offset of offsets of so many edges");
  }

  void charge_levels(const Shape& s, std::uint64_t edges, std::string_view what) {
    constexpr std::uint64_t kDeepest = 24, kEachLevel = 3;
    for (std::uint64_t k = std::min(offsets(s).depth, kDeepest); k > 0; --k) edges *= kEachLevel;
    work_.charge(edges, what);
  }

  /// The offsets that a shape is made of. A sum with what has arcs is one.
  struct Offsets {
    std::uint64_t depth = 0;
    bool of_boundary = false;  // of one of them
    std::set<exact::Real> amounts{};
  };

  const Offsets& offsets(const Shape& s) {
    if (const auto known = offsets_.find(&s); known != offsets_.end()) return known->second;
    Offsets out;
    for (const ShapePtr& child : s.children) {
      const Offsets& below = offsets(*child);
      out.depth = std::max(out.depth, below.depth);
      out.of_boundary = out.of_boundary || below.of_boundary;
      out.amounts.insert(below.amounts.begin(), below.amounts.end());
    }
    if (s.kind == Kind::kBoundary && out.depth > 0) {
      out.of_boundary = true;
      ++out.depth;
    }
    if (s.kind == Kind::kOffset) {
      const bool fresh = out.amounts.insert(abs(s.amount)).second;
      out.depth += fresh && out.of_boundary ? 2 : 1;
    }
    if (is_sum(s.kind) && (has_arcs(*child(s, 0)) || has_arcs(*child(s, 1)))) ++out.depth;
    return offsets_[&s] = std::move(out);
  }

  /// Of all operands together.
  Region hull_of(const Shape& s) {
    if (s.children.size() == 1) return hull(*child(s, 0), step_);
    std::vector<RegionPtr> operands;
    std::vector<const Region*> all;
    for (std::size_t k = 0; k < s.children.size(); ++k) all.push_back(operands.emplace_back(child(s, k)).get());
    return hull(unite(all), step_);
  }

  RegionPtr child(const Shape& s, std::size_t k) { return region(*s.children[k]); }

  double step_;
  WorkBudget work_;
  std::unordered_map<const Shape*, std::size_t> uses_;  // as a child, under this root, of those held several times
  std::unordered_map<const Shape*, std::size_t> width_;
  std::unordered_map<const Shape*, Offsets> offsets_;
  std::unordered_map<const Shape*, RegionPtr> built_;
};

bool put_contour(const Contour& contour, ByteWriter& out) {
  out.put(std::uint64_t(contour.size()));
  for (const ContourEdge& e : contour) {
    out.put(e.start);
    out.put(std::int8_t(e.arc == nullptr ? 0 : e.ccw ? 1 : -1));
    if (e.arc && !(put_real(e.arc->cx, out) && put_real(e.arc->cy, out) && put_real(e.arc->r, out))) return false;
  }
  return true;
}

/// All that the set depends on; names and places in files are left out. A shape that comes again is put as its number.
class ShapeContent {
 public:
  explicit ShapeContent(ByteWriter& out) : out_(out) {}

  bool put(const Shape& shape) {
    const auto [found, fresh] = numbers_.emplace(&shape, numbers_.size());
    out_.put(std::uint64_t(found->second));
    return !fresh || (put_own(shape) && std::all_of(shape.children.begin(), shape.children.end(),
                                                    [&](const ShapePtr& child) { return put(*child); }));
  }

 private:
  bool put_own(const Shape& shape) {
    out_.put(std::uint8_t(shape.kind));
    if (!put_real(shape.amount, out_) || !put_real(shape.degrees, out_)) return false;
    out_.put_all(std::span<const GridPoint>(shape.points));
    out_.put(std::uint64_t(shape.contours.size()));
    for (const Contour& contour : shape.contours)
      if (!put_contour(contour, out_)) return false;
    out_.put(std::int8_t(shape.cells != nullptr));
    if (shape.cells && !put_cells(*shape.cells, out_)) return false;
    out_.put(std::uint64_t(shape.children.size()));
    return true;
  }

  ByteWriter& out_;
  std::unordered_map<const Shape*, std::size_t> numbers_;
};

bool put_result(const BuildResult& result, ByteWriter& out) {
  out.put(result.rounding.points);
  out.put(result.rounding.largest);
  return put_cells(result.region, out);
}

std::optional<BuildResult> take_result(ByteReader& in) {
  BuildResult result;
  result.rounding.points = in.take<std::int64_t>();
  result.rounding.largest = in.take<double>();
  std::optional<Region> region = take_cells(in);
  if (!region) return std::nullopt;
  result.region = *std::move(region);
  return result;
}

}  // namespace

BuildResult build(const Shape& shape, double step, std::uint64_t work) {
  const auto make = [&] {
    Builder builder(shape, step, work);
    BuildResult result;
    result.region = builder.make(shape);
    result.rounding = builder.rounding;
    return result;
  };
  if (shape.children.empty()) return make();  // made sooner than found
  // Not the step: it stands in messages alone, of shapes that have no result.
  const auto content = [&](ByteWriter& out) {
    out.put(work);
    return ShapeContent(out).put(shape);
  };
  return stored<BuildResult>({"shape", content, make, put_result, take_result});
}

}  // namespace findspace::plane
