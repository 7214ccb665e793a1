// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The strip length libnest2d finds for a nesting instance: no-fit placement with the allowed rotations, scored by how
// far right a part reaches (then how far up), from the lower left corner; and its default score. Prints both with their
// times, the shorter counts. Coordinates are rounded to about 1e-6 of the strip's height, in its favour. usage:
// nest_rival INSTANCE.json
#define LIBNEST2D_GEOMETRIES_clipper
#define LIBNEST2D_OPTIMIZER_nlopt
#define LIBNEST2D_THREADING_std
#include <chrono>
#include <cstdio>
#include <fstream>
#include <libnest2d/libnest2d.hpp>
#include <nlohmann/json.hpp>

namespace {

using libnest2d::Box;
using libnest2d::Item;

struct Instance {
  std::vector<Item> items;
  std::vector<double> degrees;
  double height = 0, total = 0, longest = 0, scale = 1;
};

Instance read(const char* path, bool hulls) {
  Instance out;
  const auto data = nlohmann::json::parse(std::ifstream(path));
  out.height = data["strip_height"].get<double>();
  out.scale = 1e6 / out.height;
  for (const auto& item : data["items"]) {
    libnest2d::PolygonImpl shape;
    for (const auto& p : item["shape"]["data"])
      shape.Contour.emplace_back(std::llround(p[0].get<double>() * out.scale),
                                 std::llround(p[1].get<double>() * out.scale));
    if (ClipperLib::Orientation(shape.Contour)) ClipperLib::ReversePath(shape.Contour);
    shape.Contour.push_back(shape.Contour.front());
    out.degrees = item["allowed_orientations"].get<std::vector<double>>();
    if (hulls) shape = libnest2d::sl::convexHull(shape);
    for (int k = 0; k < item["demand"].get<int>(); ++k) {
      out.items.emplace_back(shape);
      out.total += std::abs(ClipperLib::Area(shape.Contour));
      out.longest = std::max(out.longest, double(out.items.back().boundingBox().width()));
    }
  }
  return out;
}

/// The part of the parts' area that is covered twice.
double overlap_of(const std::vector<Item>& items) {
  double twice = 0, total = 0;
  for (std::size_t i = 0; i < items.size(); ++i) {
    total += std::abs(ClipperLib::Area(items[i].transformedShape().Contour));
    for (std::size_t j = 0; j < i; ++j) {
      ClipperLib::Clipper clipper;
      clipper.AddPath(items[i].transformedShape().Contour, ClipperLib::ptSubject, true);
      clipper.AddPath(items[j].transformedShape().Contour, ClipperLib::ptClip, true);
      ClipperLib::Paths common;
      clipper.Execute(ClipperLib::ctIntersection, common, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
      for (const auto& path : common) twice += std::abs(ClipperLib::Area(path));
    }
  }
  return twice / total;
}

double run(Instance instance, bool by_length, double& overlap) {
  const double height = 1e6, width = instance.total / height * 2 + 2 * instance.longest;
  const Box bin(static_cast<libnest2d::Coord>(width), static_cast<libnest2d::Coord>(height));
  using Config = libnest2d::NestConfig<libnest2d::NfpPlacer, libnest2d::FirstFitSelection>;
  Config config;
  auto& placer = config.placer_config;
  placer.rotations.clear();
  for (double d : instance.degrees) placer.rotations.emplace_back(d * libnest2d::Pi / 180);
  placer.starting_point = libnest2d::NfpPlacer::Config::Alignment::BOTTOM_LEFT;
  placer.alignment = libnest2d::NfpPlacer::Config::Alignment::BOTTOM_LEFT;
  placer.accuracy = 1.0f;
  placer.parallel = false;
  Box pile;
  bool any = false;
  placer.before_packing = [&](const auto&, const auto& packed, const auto&) {
    any = !packed.empty();
    if (any) pile = libnest2d::sl::boundingBox(packed.front().get().transformedShape());
    for (const auto& p : packed) pile = libnest2d::sl::boundingBox(p.get().boundingBox(), pile);
  };
  if (by_length) {
    placer.object_function = [&](const Item& item) {
      const Box box = item.boundingBox(), whole = any ? libnest2d::sl::boundingBox(box, pile) : box;
      const double miss = libnest2d::NfpPlacer::overfit(whole, bin);
      return double(whole.width()) / 1e6 + double(libnest2d::getX(box.maxCorner())) / 1e8 + std::max(0.0, miss);
    };
  }
  libnest2d::nest(instance.items, bin, 0, config);
  overlap = overlap_of(instance.items);
  double low = 0, high = 0;
  bool first = true;
  for (const Item& item : instance.items) {
    if (item.binId() != 0) return -1;
    const Box box = item.boundingBox();
    low = first ? double(libnest2d::getX(box.minCorner())) : std::min(low, double(libnest2d::getX(box.minCorner())));
    high = first ? double(libnest2d::getX(box.maxCorner())) : std::max(high, double(libnest2d::getX(box.maxCorner())));
    first = false;
  }
  return (high - low) / instance.scale;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  for (bool hulls : {false, true})
    for (bool by_length : {true, false}) {
      try {
        const Instance instance = read(argv[1], hulls);
        const auto start = std::chrono::steady_clock::now();
        double overlap = 0;
        const double length = run(instance, by_length, overlap);
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        std::printf("%s, %s: length %.3f, %.2f s, overlap %.2f %%%s\n", hulls ? "hulls   " : "outlines",
                    by_length ? "length " : "default", length, seconds, overlap * 100,
                    length < 0 ? " (not all in one strip)" : "");
      } catch (const std::exception& e) {
        std::printf("%s, %s: %s\n", hulls ? "hulls   " : "outlines", by_length ? "length " : "default", e.what());
      }
    }
}
