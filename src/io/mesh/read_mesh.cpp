// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/mesh/read_mesh.h"

#include <findspace/error.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <iterator>
#include <optional>

#include "exact/number/decimal.h"
#include "io/cad/read_cad.h"
#include "io/mesh/mesh_3mf.h"
#include "io/mesh/mesh_glb.h"
#include "io/mesh/read_height_grid.h"
#include "io/mesh/read_mesh_ply.h"
#include "io/text/file_kind.h"
#include "plane/base/search_work.h"
#include "space/mesh/mesh.h"

namespace findspace::io {
namespace {

void read_obj(const std::string& bytes, MeshBuilder& out) {
  TextLines lines(bytes);
  while (lines.next()) {
    const auto& w = lines.words();
    if (w[0] == "v") {
      if (w.size() < 4) lines.fail("a vertex needs three coordinates");
      out.vertex(lines, w[1], w[2], w[3]);
    } else if (w[0] == "f") {
      std::vector<int> face;
      for (std::size_t i = 1; i < w.size(); ++i) {
        const long index = lines.integer(w[i].substr(0, w[i].find('/')));
        face.push_back(out.index(lines, index > 0 ? index - 1 : static_cast<long>(out.size()) + index));
      }
      out.face(std::move(face));
    }
  }
}

void read_off(const std::string& bytes, MeshBuilder& out) {
  TextLines lines(bytes);
  if (!lines.next()) lines.fail("an OFF file begins with OFF");
  std::vector<std::string_view> counts(lines.words());
  if (!counts[0].ends_with("OFF")) lines.fail("an OFF file begins with OFF");
  counts.erase(counts.begin());
  if (counts.empty() && lines.next()) counts = lines.words();
  if (counts.size() < 2) lines.fail("the numbers of vertices and faces are missing");
  const long vertices = lines.integer(counts[0]), faces = lines.integer(counts[1]);
  for (long i = 0; i < vertices; ++i) {
    if (!lines.next() || lines.words().size() < 3) lines.fail("a vertex is missing");
    out.vertex(lines, lines.words()[0], lines.words()[1], lines.words()[2]);
  }
  for (long i = 0; i < faces; ++i) {
    if (!lines.next()) lines.fail("a face is missing");
    const auto& w = lines.words();
    const long n = lines.integer(w[0]);
    if (n < 0 || w.size() <= static_cast<std::size_t>(n)) lines.fail("a face has fewer vertices than it says");
    std::vector<int> face;
    for (long k = 1; k <= n; ++k) face.push_back(out.index(lines, lines.integer(w[static_cast<std::size_t>(k)])));
    out.face(std::move(face));
  }
}

void read_ascii_stl(const std::string& bytes, MeshBuilder& out) {
  TextLines lines(bytes);
  std::vector<int> face;
  bool ended = false;
  while (lines.next()) {
    const auto& w = lines.words();
    ended = w[0] == "endsolid";
    if (w[0] == "outer") face.clear();
    if (w[0] == "vertex") {
      if (w.size() < 4) lines.fail("a vertex needs three coordinates");
      face.push_back(static_cast<int>(out.size()));
      out.vertex(lines, w[1], w[2], w[3]);
    }
    if (w[0] == "endloop") out.face(std::exchange(face, {}));
  }
  if (!face.empty()) lines.fail("the file ends within a facet");
  if (!ended) lines.fail("the file does not end with endsolid: it is cut off");
}

void read_binary_stl(const std::string& bytes, MeshBuilder& out) {
  const std::uint32_t count = little<std::uint32_t>(bytes, 80);
  for (std::size_t t = 0; t < count; ++t) {
    std::vector<int> face;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t at = 84 + t * 50 + 12 + k * 12;
      face.push_back(static_cast<int>(out.size()));
      out.vertex(little<float>(bytes, at), little<float>(bytes, at + 4), little<float>(bytes, at + 8));
    }
    out.face(std::move(face));
  }
}

void read_stl(const std::string& bytes, MeshBuilder& out) {
  // Binary files may begin with "solid" too; their length settles it.
  const bool binary = bytes.size() >= 84 && bytes.size() == 84 + std::size_t{50} * little<std::uint32_t>(bytes, 80);
  if (binary) return read_binary_stl(bytes, out);
  if (bytes.find("facet") == std::string::npos)
    throw Error(ErrorCode::kFile, "neither an ASCII nor a whole binary STL file");
  read_ascii_stl(bytes, out);
}

/// All solids of the file as one surface.
space::Mesh cad_mesh(const std::string& bytes, const std::string& ending, ReadContext& context,
                     const exact::Real& scale) {
  space::Mesh out;
  for (const CadPart& part : read_cad(bytes, ending, context, scale, {.balls = false})) {
    const int first = static_cast<int>(out.vertices.size());
    out.vertices.insert(out.vertices.end(), part.solid.mesh.vertices.begin(), part.solid.mesh.vertices.end());
    for (std::vector<int> face : part.solid.mesh.faces) {
      for (int& v : face) v += first;
      out.faces.push_back(std::move(face));
    }
  }
  return out;
}

bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

}  // namespace

bool TextLines::next() {
  words_.clear();
  while (words_.empty() && at_ < text_.size()) {
    std::size_t end = text_.find('\n', at_);
    if (end == std::string_view::npos) end = text_.size();
    std::string_view line = text_.substr(at_, end - at_);
    at_ = end + 1;
    ++line_;
    line = line.substr(0, line.find('#'));
    for (std::size_t i = 0; i < line.size();) {
      while (i < line.size() && is_blank(line[i])) ++i;
      std::size_t stop = i;
      while (stop < line.size() && !is_blank(line[stop])) ++stop;
      if (stop > i) words_.push_back(line.substr(i, stop - i));
      i = stop;
    }
  }
  return !words_.empty();
}

std::string TextLines::place() const { return fmt::format("line {}", line_); }

void TextLines::fail(const std::string& message) const { throw Error(ErrorCode::kSyntax, message, place()); }

long TextLines::integer(std::string_view word) const {
  long value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  const bool whole = end == word.data() + word.size();
  if (whole && error == std::errc::result_out_of_range) fail(fmt::format("'{}' is too large", word));
  if (error != std::errc{} || !whole) fail(fmt::format("'{}' is not a whole number", word));
  return value;
}

void MeshBuilder::vertex(const TextLines& lines, std::string_view x, std::string_view y, std::string_view z) {
  std::array<double, 3> moved{};
  const std::int64_t gx = on_grid(lines, x, moved[0]), gy = on_grid(lines, y, moved[1]),
                     gz = on_grid(lines, z, moved[2]);
  add({gx, gy, gz}, moved);
}

MeshBuilder::MeshBuilder(ReadContext& context, const exact::Real& scale) : context_(context), scale_(scale) {
  if (scale.sign() > 0) step_ = context.grid.step() / scale;
  constexpr std::int64_t kMostSteps = std::int64_t{1} << 53;
  const auto steps = (scale / context.grid.step()).integer();
  if (steps && *steps > 0 && *steps <= kMostSteps) steps_ = double(*steps);
}

std::int64_t MeshBuilder::on_grid(const TextLines& lines, std::string_view coordinate, double& moved) const {
  if (const auto steps = exact::grid_integer(coordinate, step_)) return *steps;
  exact::Real number;
  try {
    number = exact::Real::parse_decimal(coordinate);
  } catch (const Error&) {
    lines.fail(fmt::format("'{}' is not a number", coordinate));
  }
  return on_grid(number, moved);
}

std::int64_t MeshBuilder::on_grid(const exact::Real& coordinate, double& moved) const {
  return context_.grid.nearest(coordinate * scale_, moved);
}

/// The number of steps is the sum of two doubles, exactly, and rounded from it unless it is nearly a tie.
std::int64_t MeshBuilder::on_grid(double coordinate, double& moved) const {
  constexpr double kNearlyHalf = 0.49;
  const double steps = coordinate * steps_, rest = std::fma(coordinate, steps_, -steps), whole = std::nearbyint(steps),
               off = (steps - whole) + rest;
  const bool clear = steps_ > 0 && std::abs(steps) < double(plane::Grid::kLimit) && std::abs(off) < kNearlyHalf;
  if (!clear) return on_grid(exact::Real::from_double(coordinate), moved);
  moved = std::abs(off);
  return static_cast<std::int64_t>(whole);
}

void MeshBuilder::vertex(double x, double y, double z) {
  if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z))
    throw Error(ErrorCode::kBadValue, "a coordinate is not finite");
  std::array<double, 3> moved{};
  const std::int64_t gx = on_grid(x, moved[0]), gy = on_grid(y, moved[1]), gz = on_grid(z, moved[2]);
  add({gx, gy, gz}, moved);
}

void MeshBuilder::vertex(const std::array<exact::Real, 3>& p) {
  std::array<double, 3> moved{};
  const std::int64_t gx = on_grid(p[0], moved[0]), gy = on_grid(p[1], moved[1]), gz = on_grid(p[2], moved[2]);
  add({gx, gy, gz}, moved);
}

void MeshBuilder::add(const space::Point& at, const std::array<double, 3>& moved) {
  mesh_.vertices.push_back(at);
  context_.rounding.add(moved[0], std::hypot(moved[1], moved[2]));
}

int MeshBuilder::index(const TextLines& lines, long index) const {
  if (index < 0 || index >= static_cast<long>(size())) lines.fail("a face refers to a vertex that is not there");
  return static_cast<int>(index);
}

space::Mesh parse_mesh(const std::string& bytes, const std::string& ending, ReadContext& context,
                       const MeshScale& scale) {
  if (ending == ".3mf") return read_3mf(bytes, context, scale);
  if (ending == ".glb") {
    MeshBuilder builder(context, scale(exact::Real(1000)));  // metres
    read_glb(bytes, context, builder);
    return std::move(builder.mesh());
  }
  if (is_cad_ending(ending)) return cad_mesh(bytes, ending, context, scale(exact::Real(1)));
  MeshBuilder builder(context, scale(std::nullopt));
  if (ending == ".obj")
    read_obj(bytes, builder);
  else if (ending == ".off")
    read_off(bytes, builder);
  else if (ending == ".stl")
    read_stl(bytes, builder);
  else if (ending == ".ply")
    read_ply(bytes, builder);
  else if (ending == kHeightGridEnding)
    throw Error(ErrorCode::kFile, "a grid of heights is no mesh by itself: state it as a shape with a \"floor\"");
  else
    throw Error(ErrorCode::kFile,
                fmt::format("a solid is read from {}, not '{}'", fmt::join(file_endings(true), " "), ending));
  return std::move(builder.mesh());
}

space::Mesh read_mesh(const std::filesystem::path& path, ReadContext& context, const MeshScale& scale) {
  const std::string bytes = context.take_file(path);
  const std::string ending = lower_ending(path.extension().string());
  require_kind(bytes, ending, path.string());
  const plane::SearchLimit most{context.options.work_limit};
  const plane::ScopedSearchLimit allowed(&most);
  try {
    space::Mesh mesh = parse_mesh(bytes, ending, context, scale);
    for (const std::string& note : space::clean(mesh, context.grid.step_size(), context.drawing.repair)) {
      context.notes.push_back(fmt::format("{}: {}", path.filename().string(), note));
    }
    return mesh;
  } catch (const Error& e) {
    throw e.within(path.string());
  }
}

}  // namespace findspace::io
