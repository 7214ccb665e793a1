// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/board/read_board.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <utility>

#include "io/board/board_pad.h"
#include "io/board/read_groups.h"
#include "io/board/read_part.h"

namespace findspace::io {
namespace {

using exact::Real;
using plane::ShapePtr;

constexpr int kKiCad5 = 20171130, kKiCad6 = 20211014, kAfterKiCad9 = 20250000;

class BoardReader {
 public:
  explicit BoardReader(const Sexpr& root) : root_(root), edges_(context_) { context_.unit = Unit::kMillimetre; }

  Board read(const std::string& name) {
    board_.file = name;
    read_header();
    const LayerNames names = [this](const std::string& layer) { return layer_name(layer); };
    PartReader parts{context_, names, edges_, board_};
    std::vector<Sexpr> footprints;
    root_.each([&](const Sexpr& item) {
      if (is_footprint(item)) footprints.push_back(item);
    });
    const std::vector<std::string> part_name = part_names(footprints);
    for (std::size_t k = 0; k < footprints.size(); ++k) board_.parts.push_back(parts.read(footprints[k], part_name[k]));
    read_groups(root_, footprints, board_);
    root_.each([&](const Sexpr& item) { read_item(item, names); });
    read_outline();
    add_notes();
    return std::move(board_);
  }

 private:
  void read_header() {
    if (!root_.is("kicad_pcb")) root_.fail(ErrorCode::kFile, "a board of KiCad is meant: (kicad_pcb ...)");
    const auto version = root_.need("version").item(0).number().integer();
    if (!version || *version < kKiCad5)
      root_.need("version").fail(ErrorCode::kUnsupported,
                                 "a board of KiCad 4 or older; save it in KiCad 5 or later and read that");
    if (*version > kAfterKiCad9) board_.notes.push_back("the board comes from a KiCad after version 9");
    root_.need("layers").each([&](const Sexpr& layer) {
      if (layer.is_list()) read_layer(layer, *version < kKiCad6);
    });
    root_.each([&](const Sexpr& item) {
      if (item.is("net") && item.items().size() > 1) nets_[item.item(0).text()] = item.item(1).text();
    });
  }

  /// (0 "F.Cu" signal); `own_names`: copper layers, which have the numbers up to 31, may be called anything.
  void read_layer(const Sexpr& layer, bool own_names) {
    constexpr int kBack = 31;
    const std::string_view digits = layer.head();
    int number = kBack + 1;
    std::from_chars(digits.data(), digits.data() + digits.size(), number);
    const std::string given = layer.item(0).text();
    if (own_names && (number == 0 || number == kBack)) names_[given] = number == 0 ? "F.Cu" : "B.Cu";
    const std::string name = layer_name(given);
    if (name.ends_with(".Cu") || (own_names && number <= kBack)) copper_.push_back(name);
  }

  std::string layer_name(const std::string& layer) const {
    const auto found = names_.find(layer);
    return found == names_.end() ? layer : found->second;
  }

  void read_item(const Sexpr& item, const LayerNames& names) {
    const std::string_view head = item.head();
    if (head.substr(0, 3) == "gr_") {
      const auto layer = item.find("layer");
      if (layer && layer->item(0).text() == "Edge.Cuts") edges_.add(item, Affine{});
    } else if (head == "segment" || head == "arc") {
      read_track(item, names);
    } else if (head == "via") {
      read_via(item, names);
    } else if (head == "zone" && !add_keep_out(item, "", names, context_, board_)) {
      read_zone(item, names);
    }
  }

  /// KiCad lets the outline of a zone cross itself. No part has to mind a zone, so the board is read without it.
  void read_zone(const Sexpr& zone, const LayerNames& names) {
    try {
      if (const ShapePtr area = zone_area(zone, context_))
        board_.zones.push_back({net_of(zone), layers_of(zone, names), area});
    } catch (const Error& e) {
      if (e.code() != ErrorCode::kGeometry) throw;
      board_.notes.push_back(
          fmt::format("{}: a zone of net '{}' is left out: its outline touches or crosses itself, or has no area",
                      zone.place(), net_of(zone)));
    }
  }

  /// (net 3), whose name the list of nets has, or (net "GND").
  std::string net_of(const Sexpr& item) const {
    const auto net = item.find("net");
    if (!net) return "";
    const std::string number = net->item(0).text();
    const auto found = nets_.find(number);
    return found == nets_.end() ? number : found->second;
  }

  void read_track(const Sexpr& item, const LayerNames& names) {
    Graphics graphics(context_);
    graphics.add_track(item);
    const Real width = context_.grid.steps(item.need("width").item(0).number());
    plane::Contour chain = graphics.chain();
    if (chain.empty()) {
      const Sexpr start = item.need("start");
      const plane::GridPoint p =
          context_.grid.nearest(start.item(0).number(), start.item(1).number(), context_.rounding);
      chain = {{.start = p}, {.start = p}};
    }
    board_.tracks.push_back({net_of(item), layers_of(item, names), stroke(std::move(chain), width, item.place())});
  }

  /// The copper layers that a via goes through: it states the first and the last.
  std::vector<std::string> via_layers(const Sexpr& via, const LayerNames& names) const {
    std::vector<std::string> stated = layers_of(via, names);
    if (stated.size() != 2) return stated;
    auto first = std::find(copper_.begin(), copper_.end(), stated[0]);
    auto last = std::find(copper_.begin(), copper_.end(), stated[1]);
    if (first == copper_.end() || last == copper_.end()) return stated;
    if (last < first) std::swap(first, last);
    return std::vector<std::string>(first, last + 1);
  }

  void read_via(const Sexpr& item, const LayerNames& names) {
    const Sexpr at = item.need("at");
    const plane::GridPoint p = context_.grid.nearest(at.item(0).number(), at.item(1).number(), context_.rounding);
    const Real size = context_.grid.steps(item.need("size").item(0).number() / Real(2));
    board_.vias.push_back({net_of(item), via_layers(item, names), disc(p, size, item.place())});
    if (const auto drill = item.find("drill"))
      board_.holes.push_back({"", disc(p, context_.grid.steps(drill->item(0).number() / Real(2)), item.place())});
  }

  void read_outline() {
    const std::string place = "the outline on Edge.Cuts (" + board_.file + ")";
    if (edges_.empty()) throw Error(ErrorCode::kGeometry, "the board has no outline: nothing is drawn there", place);
    auto closed = edges_.closed(place);
    const double step = context_.grid.step_size();
    if (!closed) {
      const plane::GridPoint p = edges_.open_end();
      throw Error(ErrorCode::kGeometry,
                  fmt::format("it is open at ({}, {}); ends up to {} mm apart are joined", show(double(p.x) * step),
                              show(double(p.y) * step), show(double(kGap) * step)),
                  place)
          .at(double(p.x) * step, double(p.y) * step);
    }
    if (closed->size() > 1)
      throw Error(ErrorCode::kUnsupported, fmt::format("it has {} separate pieces; one board is read", closed->size()),
                  place);
    if (edges_.joined() > 0)
      board_.notes.push_back(fmt::format("the outline: {} ends up to {} mm apart were joined", edges_.joined(),
                                         show(double(kGap) * step)));
    board_.outline = closed->front();
  }

  void add_notes() {
    const auto count = [&](auto wanted) { return std::count_if(board_.parts.begin(), board_.parts.end(), wanted); };
    const auto stand_in = count([](const Part& p) { return p.stands_in; });
    if (stand_in > 0)
      board_.notes.push_back(
          fmt::format("{} of {} parts without a closed courtyard: the box about pads and body stands in", stand_in,
                      board_.parts.size()));
    const auto joined = std::find_if(board_.parts.begin(), board_.parts.end(), [](const Part& p) { return p.joined; });
    if (joined != board_.parts.end()) {
      const auto n = count([](const Part& p) { return p.joined; });
      board_.notes.push_back(fmt::format("the {}: ends up to {} mm apart were joined",
                                         n == 1 ? fmt::format("courtyard of {}", joined->name)
                                                : fmt::format("courtyards of {} parts, the first {}", n, joined->name),
                                         show(double(kCourtyardGap) * context_.grid.step_size())));
    }
    const auto drawings = count([](const Part& p) { return p.body == nullptr; });
    if (drawings > 0)
      board_.notes.push_back(fmt::format("{} footprints are drawings without pads or body: left out", drawings));
    if (!context_.notes.empty())
      board_.notes.push_back(fmt::format("{} Bézier curves, the first at {}, are read as segments, at most {} mm off",
                                         context_.notes.size(), context_.notes.front(),
                                         show(double(kCurve) * context_.grid.step_size())));
    const RoundingLog& log = context_.rounding;
    if (log.points > 0)
      board_.notes.push_back(fmt::format("{} points rounded to the grid, largest move {} mm", log.points,
                                         show(log.largest * context_.grid.step_size())));
  }

  Sexpr root_;
  ReadContext context_;
  Graphics edges_;
  Board board_;
  std::map<std::string, std::string> names_, nets_;
  std::vector<std::string> copper_;  // layers from front to back
};

/// Whether several footprints may have it: none, or one that was never given, "REF**".
bool is_shared(const std::string& reference) { return reference.empty() || reference.back() == '*'; }

}  // namespace

const Part* Board::find(std::string_view name) const {
  const auto found = std::find_if(parts.begin(), parts.end(), [&](const Part& p) { return p.name == name; });
  return found == parts.end() ? nullptr : &*found;
}

bool is_footprint(const Sexpr& item) { return item.is("footprint") || item.is("module"); }

std::string reference_of(const Sexpr& footprint) {
  std::string out;
  footprint.each([&](const Sexpr& item) {
    const bool text = item.is("fp_text") && item.item(0).text() == "reference";
    const bool property = item.is("property") && item.item(0).text() == "Reference";
    if (out.empty() && (text || property)) out = item.item(1).text();
  });
  return out;
}

std::vector<std::string> part_names(const std::vector<Sexpr>& footprints) {
  std::map<std::string, Sexpr> known;
  std::vector<std::string> out;
  for (const Sexpr& footprint : footprints) {
    const std::string reference = reference_of(footprint);
    std::string name = reference.empty() ? "part" : reference;
    for (int k = 2; is_shared(reference) && known.count(name) > 0; ++k)
      name = fmt::format("{} {}", reference.empty() ? "part" : reference, k);
    const auto [found, fresh] = known.emplace(name, footprint);
    if (!fresh)
      footprint.fail(ErrorCode::kGeometry,
                     fmt::format("a second footprint '{}'; the first is at {}", name, found->second.place()));
    out.push_back(std::move(name));
  }
  return out;
}

Board read_board(std::string_view text, const std::string& name) {
  const SexprTree tree(text, name);
  return BoardReader(tree.root()).read(name);
}

}  // namespace findspace::io
