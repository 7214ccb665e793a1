// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "serve/packing_job.h"

#include <findspace/error.h>
#include <findspace/text.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "placing/packing_report.h"
#include "serve/space_drawing.h"

namespace findspace::app {
namespace {

/// As far as an item that is moved by so much can reach then, and more.
void lengthen(Number& size, double by) {
  size = fmt::format("{:.0f}", std::ceil(size.value() + std::max(0.0, by)) + 1);
}

/// What packings in the plane and in space do differently.
struct Plane {
  using Problem = Packing;
  using Layout = PackLayout;
  static constexpr std::size_t kDimension = 2;
  static constexpr const char *kSize = "length", *kHolder = "sheet";

  static Packing read(const std::string& problem, const PackReading& asked) { return Packing::json(problem, asked); }
  static std::string holder(const Packing& packing, bool drawn) {
    const PackProblem& problem = packing.problem();
    if (problem.box) return R"("box": true)";
    if (problem.sheets.empty()) return fmt::format(R"("height": {})", json_number(problem.height.value()));
    std::size_t k = 0;
    return fmt::format(R"("sheets": {})", json_list(problem.sheets, [&](const PackSheet& sheet) {
                         const std::size_t kind = k++;
                         return fmt::format(R"({{"name": {}, "count": {}{}}})", json_string(sheet.name), sheet.count,
                                            drawn ? looks(packing, kind) : "");
                       }));
  }
  static std::string looks(const Packing& packing, std::size_t sheet) {
    return fmt::format(R"(, "drawing": {}, "zones": {})", json_string(packing.sheet_outline(sheet)),
                       json_string(packing.sheet_zones(sheet)));
  }
  static std::string drawing(const Packing& packing, std::size_t part) { return json_string(packing.outline(part)); }
  static Number& size(PackLayout& layout) { return layout.length; }
  static std::array<Number*, 2> place(PlacedPart& item) { return {&item.x, &item.y}; }
  static std::size_t& holder_of(PlacedPart& item) { return item.sheet; }
  static std::size_t holders(const PackLayout& layout) { return layout.sheets.size(); }
  static void grow(const Packing& packing, PackLayout& layout, const std::array<double, 2>& by) {
    if (!packing.problem().sheets.empty()) return;
    lengthen(layout.length, by[0]);
    if (packing.problem().box) lengthen(layout.height, by[1]);
  }
  static std::optional<PackLayout> moved(const Packing& packing, const PackLayout& layout, const MovedItem& to) {
    return packing.moved(layout, to.item, {to.at[0].value(), to.at[1].value()});
  }
};

struct Space {
  using Problem = SolidPacking;
  using Layout = SolidPackLayout;
  static constexpr std::size_t kDimension = 3;
  static constexpr const char *kSize = "height", *kHolder = "container";

  static SolidPacking read(const std::string& problem, const PackReading& asked) {
    if (asked.height)
      throw Error(ErrorCode::kUsage, "--height is of strips in the plane; in space the height is sought", asked.name);
    return SolidPacking::json(problem, asked);
  }
  static std::string holder(const SolidPacking& packing, bool drawn) {
    const SolidPackProblem& problem = packing.problem();
    if (problem.containers.empty())
      return fmt::format(R"("floor": [{}, {}])", json_number(problem.width.value()),
                         json_number(problem.depth.value()));
    std::size_t k = 0;
    return fmt::format(R"("containers": {})", json_list(problem.containers, [&](const PackContainer& c) {
                         return fmt::format(R"({{"name": {}, {}}})", json_string(c.name), inside(packing, k++, drawn));
                       }));
  }
  static std::string inside(const SolidPacking& packing, std::size_t container, bool drawn) {
    Surface surface = packing.inside(container);
    const std::array<double, 3> size = sides_of(surface);
    return fmt::format(R"("size": [{}, {}, {}]{})", json_number(size[0]), json_number(size[1]), json_number(size[2]),
                       drawn ? ", \"drawing\": " + drawing(std::move(surface)) : "");
  }
  /// Of what begins at the origin.
  static std::array<double, 3> sides_of(const Surface& surface) {
    std::array<double, 3> sides{};
    for (const Position3& v : surface.vertices)
      for (std::size_t k = 0; k < 3; ++k) sides[k] = std::max(sides[k], v[k]);
    return sides;
  }
  static std::string drawing(const SolidPacking& packing, std::size_t part) { return drawing(packing.outline(part)); }
  static std::string drawing(Surface surface) { return SpaceDrawing{std::move(surface), {}}.json(); }
  static Number& size(SolidPackLayout& layout) { return layout.height; }
  static std::array<Number*, 3> place(PlacedSolid& item) { return {&item.at.x, &item.at.y, &item.at.z}; }
  static std::size_t& holder_of(PlacedSolid& item) { return item.container; }
  static std::size_t holders(const SolidPackLayout& layout) { return layout.containers.size(); }
  /// In containers by the whole last one: what is moved into it may come from another.
  static void grow(const SolidPacking& packing, SolidPackLayout& layout, const std::array<double, 3>& by) {
    const std::vector<PackContainer>& kinds = packing.problem().containers;
    if (kinds.empty()) return lengthen(layout.height, by[2]);
    const auto is_last = [&](const PackContainer& kind) { return kind.name == layout.containers.back(); };
    const auto last = std::find_if(kinds.begin(), kinds.end(), is_last);
    lengthen(layout.height, sides_of(packing.inside(std::size_t(last - kinds.begin())))[2]);
  }
  static std::optional<SolidPackLayout> moved(const SolidPacking& packing, const SolidPackLayout& layout,
                                              const MovedItem& to) {
    return packing.moved(layout, to.item, {to.at[0], to.at[1], to.at[2]});
  }
};

template <class Kind>
class JobOf : public PackingJob {
 public:
  using Layout = typename Kind::Layout;

  JobOf(const std::string& problem, const PackReading& asked) : packing_(Kind::read(problem, asked)) {}
  ~JobOf() override { stop(); }

  void begin_with(const std::string& layout) override { begin(packing_.layout(layout)); }
  void begin_with_file(const std::filesystem::path& layout, std::uint64_t most) override {
    begin(start_layout(packing_, layout, most));
  }

  void repair(const MovedItem& moved) override {
    stop();
    const Layout before = known(moved);
    std::optional<Layout> made = Kind::moved(packing_, before, moved);
    if (!made) throw Error(ErrorCode::kGeometry, "the other parts cannot make room there");
    made->seconds = before.seconds;
    made->seed = before.seed;
    made->threads = before.threads;
    keep(*made, progress_of(*made));
  }

  std::string verdict_json(const std::optional<MovedItem>& moved) const override {
    Layout layout = moved ? known(*moved) : best();
    if (moved) put(layout, *moved);
    return app::verdict_json(layout.items.size(), size_of(layout), packing_.verdict(layout));
  }

  std::string problem_json(bool drawing) const override {
    const auto& problem = packing_.problem();
    std::size_t k = 0;
    const std::string parts = json_list(problem.parts, [&](const auto& p) {
      const std::size_t part = k++;
      return fmt::format(R"({{"name": {}, "demand": {}{}}})", json_string(p.name), p.count,
                         drawing ? ", \"drawing\": " + Kind::drawing(packing_, part) : "");
    });
    return fmt::format(R"({{"name": {}, "dimension": {}, {}, "lower_bound": {}, "items": {}, "parts": {}}})",
                       json_string(problem.name), Kind::kDimension, Kind::holder(packing_, drawing),
                       json_number(packing_.lower_bound().value()), packing_.copies(), parts);
  }

 private:
  static PackProgress progress_of(Layout& layout) {
    PackProgress state;
    state.length = Kind::size(layout).value();
    state.density = layout.density;
    state.seconds = layout.seconds;
    return state;
  }

  void begin(Layout layout) {
    if (!packing_.verdict(layout).feasible())
      throw Error(ErrorCode::kGeometry, "the layout to begin with is not feasible; verify says why");
    stop();
    keep(layout, progress_of(layout));
  }

  void keep(const Layout& layout, const PackProgress& state) {
    const std::lock_guard lock(guard_);
    best_ = layout;
    count(state);
  }

  /// The best layout. Throws Error.
  Layout best() const {
    const std::lock_guard lock(guard_);
    if (!best_) throw Error(ErrorCode::kBadValue, "there is no layout yet");
    return *best_;
  }

  /// The same, with that item in the sheet or container that it is moved to.
  Layout known(const MovedItem& moved) const {
    Layout layout = best();
    const std::size_t items = layout.items.size();
    if (moved.item >= items)
      throw Error(ErrorCode::kBadValue,
                  items == 0 ? "the layout has no items" : fmt::format("the layout has items 0 to {}", items - 1));
    if (moved.at.size() != Kind::kDimension)
      throw Error(ErrorCode::kBadValue, fmt::format("a place of this layout has {} numbers", Kind::kDimension));
    if (!moved.in) return layout;
    const std::size_t holders = Kind::holders(layout);
    if (*moved.in >= std::max<std::size_t>(1, holders))
      throw Error(ErrorCode::kBadValue, fmt::format("the layout has no {} {}", Kind::kHolder, *moved.in));
    Kind::holder_of(layout.items[moved.item]) = *moved.in;
    return layout;
  }

  /// The strip may become longer, and what stands upon a floor or in the last container higher.
  void put(Layout& layout, const MovedItem& moved) const {
    const auto place = Kind::place(layout.items[moved.item]);
    std::array<double, Kind::kDimension> by{};
    for (std::size_t k = 0; k < Kind::kDimension; ++k) by[k] = moved.at[k].value() - place[k]->value();
    Kind::grow(packing_, layout, by);
    for (std::size_t k = 0; k < Kind::kDimension; ++k) *place[k] = moved.at[k];
  }

  void search(const findspace::Options& options) override {
    PackSearch<Layout> search;
    search.start = best_;
    search.better = [&](const Layout& layout, const PackProgress& state) { keep(layout, state); };
    search.progress = [&](const PackProgress& state) {
      const std::lock_guard lock(guard_);
      state_ = state;
    };
    packing_.search(options, search);
  }

  std::string layout_member() const override {
    if (!best_) return "";
    const std::string layout = packing_.json(*best_);
    const std::size_t from = layout.find("\"layout\"");
    return layout.substr(from, layout.rfind('}') - from);
  }
  const char* size_word() const override { return Kind::kSize; }

  typename Kind::Problem packing_;
  std::optional<Layout> best_;
};

}  // namespace

std::unique_ptr<PackingJob> PackingJob::make(const std::string& problem, const PackReading& asked) {
  if (SolidPacking::is_stated_in(problem, asked.name)) return std::make_unique<JobOf<Space>>(problem, asked);
  return std::make_unique<JobOf<Plane>>(problem, asked);
}

void PackingJob::stop() {
  stop_.request();
  if (thread_.joinable()) thread_.join();
}

void PackingJob::count(const PackProgress& state) {
  state_ = state;
  ++number_;
}

void PackingJob::start(const PackingStart& start) {
  stop();
  findspace::Options options;
  options.seed = start.seed;
  options.threads = start.threads;
  options.seconds = start.seconds;
  options.cancel = stop_;
  failure_.clear();
  stop_.reset();
  running_ = true;
  thread_ = std::thread([this, options] {
    try {
      search(options);
    } catch (const std::exception& e) {
      const std::lock_guard lock(guard_);
      failure_ = e.what();
    }
    running_ = false;
  });
}

std::string PackingJob::state_json(std::uint64_t since) const {
  const std::lock_guard lock(guard_);
  std::string out =
      fmt::format(R"({{"running": {}, "number": {}, "seconds": {:.3f}, "{}": {}, "density": {})", running_.load(),
                  number_, state_.seconds, size_word(), json_number(state_.length), json_number(state_.density));
  if (!failure_.empty()) out += ", \"failure\": " + json_string(failure_);
  if (const std::string layout = number_ > since ? layout_member() : ""; !layout.empty()) out += ", " + layout;
  return out + "}";
}

}  // namespace findspace::app
