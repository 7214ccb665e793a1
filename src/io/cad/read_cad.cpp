// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/cad/read_cad.h"

#include <findspace/error.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <new>
#include <set>

#include "io/cad/cad_library.h"
#include "io/cad/cad_model.h"
#include "io/cad/sided_mesh.h"
#include "space/mesh/mesh.h"

namespace findspace::io {
namespace {

using exact::Real;
using space::Solid;

constexpr std::size_t kMostTriangles = 2'000'000;
constexpr std::uint64_t kTriangleWork = 10;  // units

[[noreturn]] void raise(const CadProblem& problem) {
  if (problem.fault == CadFault::kMemory) throw std::bad_alloc();
  static constexpr std::array<ErrorCode, 5> kCodes{ErrorCode::kUnsupported, ErrorCode::kFile, ErrorCode::kSyntax,
                                                   ErrorCode::kGeometry, ErrorCode::kUnsupported};
  throw Error(kCodes[static_cast<std::size_t>(problem.fault)], problem.message);
}

/// Millimetres as doubles become grid points. A double is taken as the decimal with as many places as all coordinates
/// of the file's solid have in 15 digits: what Open CASCADE rounds when it composes placements and units lies beyond.
class CadGrid {
 public:
  CadGrid(const ReadContext& context, const Real& scale, double size) : grid_(context.grid), scale_(scale) {
    constexpr int kDigits = 14;
    const int whole = size >= 1 ? static_cast<int>(std::floor(std::log10(size))) + 1 : 0;
    places_ = std::max(0, kDigits - whole);
    steps_ = (scale / grid_.step()).to_double();
  }

  Real length(double millimetres) const {
    return Real::parse_decimal(fmt::format("{:.{}f}", millimetres, places_)) * scale_;
  }
  std::int64_t nearest(double millimetres, double& moved) const { return grid_.nearest(length(millimetres), moved); }
  /// Grid steps a millimetre.
  double steps() const { return steps_; }

 private:
  const Grid& grid_;
  Real scale_;
  int places_ = 0;
  double steps_ = 0;
};

/// The places of a mesh on the grid.
struct GridPlaces {
  std::vector<space::Point> points;
  std::vector<std::array<double, 3>> moved;

  GridPlaces(const std::vector<CadPlace>& places, const CadGrid& grid) {
    for (const CadPlace& p : places) {
      std::array<double, 3>& by = moved.emplace_back();
      points.push_back({grid.nearest(p[0], by[0]), grid.nearest(p[1], by[1]), grid.nearest(p[2], by[2])});
    }
  }
};

double size_of(const std::vector<CadPlace>& places) {
  double size = 0;
  for (const CadPlace& p : places) size = std::max({size, std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
  return size;
}

class SolidOfCad {
 public:
  SolidOfCad(const CadFile& file, std::size_t index, const std::string& name, ReadContext& context, const Real& scale)
      : file_(file), index_(index), name_(name), context_(context), scale_(scale) {}

  /// The part, but for its name.
  CadPart part(bool balls) {
    CadPart out;
    if (const auto rounded = file_.rounded(index_); rounded && balls)
      out.balls = balls_of(*rounded);
    else
      out.solid = meshed();
    return out;
  }

 private:
  Solid meshed() {
    const double tolerance = context_.drawing.tolerance;
    CadMesh mesh = mesh_within(tolerance - kForGrid);
    if (flat(mesh)) return of_planes(mesh);
    if (context_.drawing.curves == CurveRule::kNear) return near(mesh);
    return sided(tolerance);
  }

  /// By so many grid steps at most.
  CadMesh mesh_within(double steps) const {
    CadMesh mesh;
    const CadProblem problem = file_.mesh(index_, steps / steps_a_millimetre(), kMostTriangles, mesh);
    if (problem.fault != CadFault::kNone) raise(problem);
    context_.work.charge(kTriangleWork * mesh.faces.size(), "meshing a CAD file so finely");
    return mesh;
  }
  double steps_a_millimetre() const { return (scale_ / context_.grid.step()).to_double(); }
  static bool flat(const CadMesh& mesh) {
    return std::all_of(mesh.faces.begin(), mesh.faces.end(), [](const CadFace& f) { return f.flat; });
  }

  std::vector<Solid> balls_of(const CadRounded& rounded) {
    const CadGrid grid(context_, scale_, std::max(size_of(rounded.centers), rounded.radius));
    const GridPlaces places(rounded.centers, grid);
    log(places);
    std::vector<Solid> out;
    for (const space::Point& center : places.points) {
      Solid& ball = out.emplace_back();
      ball.form = Solid::Form::kBall;
      ball.mesh.vertices = {center};
      ball.radius = context_.grid.steps(grid.length(rounded.radius));
    }
    return out;
  }

  /// Vertices of the file that had to be rounded.
  void log(const GridPlaces& places) {
    for (const auto& [x, y, z] : places.moved) context_.rounding.add(x, std::hypot(y, z));
  }

  Solid of_planes(const CadMesh& mesh) {
    const GridPlaces places(mesh.places, CadGrid(context_, scale_, size_of(mesh.places)));
    log(places);
    Solid solid;
    solid.form = Solid::Form::kMesh;
    solid.mesh.vertices = places.points;
    for (const CadFace& face : mesh.faces) solid.mesh.faces.push_back(face.corners);
    for (const std::string& note : space::clean(solid.mesh, context_.grid.step_size()))
      context_.notes.push_back(fmt::format("{}: {}", name_, note));
    return solid;
  }

  Solid near(const CadMesh& mesh) {
    const CadGrid grid(context_, scale_, size_of(mesh.places));
    const GridPlaces places(mesh.places, grid);
    space::Triangles surface{places.points, {}};
    for (const CadFace& face : mesh.faces) surface.faces.push_back({face.corners[0], face.corners[1], face.corners[2]});
    double rounded = 0;
    for (const auto& [x, y, z] : places.moved) rounded = std::max(rounded, std::hypot(x, y, z));
    return done(surface, mesh, mesh.bound * grid.steps() + rounded, "near");
  }

  /// First a mesh that is near within a part of the tolerance, then moved to its side; nearer, if that took too much.
  Solid sided(double tolerance) {
    const bool outside = context_.drawing.curves == CurveRule::kOutside;
    double part = tolerance * kFirstPart;
    std::string why;
    for (int k = 0; k < kTries && part >= kLeastSteps; ++k) {
      const CadMesh mesh = mesh_within(part);
      const CadGrid grid(context_, scale_, size_of(mesh.places));
      const NearMesh from = near_mesh(mesh, grid);
      const exact::Tried<SidedMesh> to = sided_mesh(from, outside);
      if (!to) {
        why = to.refusal().error.message();
        part *= kLess;
        continue;
      }
      const double bound = mesh.bound * grid.steps() + kForGrid + to->most_moved;
      if (bound <= tolerance) return done(to->surface, mesh, bound, outside ? "outside" : "inside");
      why = fmt::format("its sharpest edges need a bound of {}", context_.length_text(bound));
      part *= kLess * std::min(1.0, tolerance / bound);
    }
    throw Error(ErrorCode::kUnsupported,
                fmt::format("no mesh {} the solid was found within the tolerance: {}; another --tolerance or a finer "
                            "\"grid\" may help, or --curves near",
                            outside ? "outside" : "inside", why));
  }

  NearMesh near_mesh(const CadMesh& mesh, const CadGrid& grid) const {
    const GridPlaces places(mesh.places, grid);
    NearMesh out;
    out.surface.points = places.points;
    out.surface.step = context_.grid.step_size();
    for (const auto& [x, y, z] : places.moved) out.moved.push_back({x > 0, y > 0, z > 0});
    for (const CadFace& face : mesh.faces) {
      out.surface.faces.push_back({face.corners[0], face.corners[1], face.corners[2]});
      NearFace& to = out.faces.emplace_back();
      to.face = face.face;
      to.flat = face.flat;
      // Of a flat face what its corners are off its plane, as doubles have it.
      const double steps = face.bound * grid.steps();
      to.off = face.flat ? std::llround(steps) : static_cast<std::int64_t>(std::ceil(steps));
      to.even = even_axis(face.even, steps);
    }
    return out;
  }

  /// The axis that the direction is, up to what doubles lose: so much of the error along it is less than a step.
  static int even_axis(const CadPlace& way, double steps) {
    for (int axis = 0; axis < 3; ++axis) {
      const double other = std::hypot(way[std::size_t((axis + 1) % 3)], way[std::size_t((axis + 2) % 3)]);
      if (way[std::size_t(axis)] != 0 && other * steps * kHidden < 1) return axis;
    }
    return -1;
  }

  Solid done(const space::Triangles& surface, const CadMesh& mesh, double bound, const char* side) {
    Solid solid;
    solid.form = Solid::Form::kMesh;
    solid.mesh.vertices = surface.points;
    for (const auto& f : surface.faces) solid.mesh.faces.push_back({f[0], f[1], f[2]});
    space::clean(solid.mesh, context_.grid.step_size());
    std::set<int> curved;
    for (const CadFace& f : mesh.faces)
      if (!f.flat) curved.insert(f.face);
    context_.notes.push_back(fmt::format("{}: {} curved {} of {} triangles, proved to be within {:.3g}{} ({})", name_,
                                         curved.size(), curved.size() == 1 ? "face became part" : "faces became part",
                                         surface.faces.size(), bound * context_.grid.step_size(),
                                         context_.unit ? fmt::format(" {}", formula::name(*context_.unit)) : "", side));
    return solid;
  }

  static constexpr double kForGrid = 2;                    // grid steps: a corner moves by less
  static constexpr double kFirstPart = 0.25, kLess = 0.7;  // of the tolerance; of the last part
  static constexpr double kLeastSteps = 4, kHidden = 1'000'000;
  static constexpr int kTries = 5;

  const CadFile& file_;
  std::size_t index_;
  const std::string& name_;
  ReadContext& context_;
  const Real& scale_;
};

std::unique_ptr<CadFile> open_cad(const std::string& bytes, const std::string& ending) {
  std::string why;
  ReadCad* const read = cad_reader(&why);
  if (read == nullptr && !why.empty())
    throw Error(ErrorCode::kUnsupported,
                fmt::format("STEP and IGES are read by Open CASCADE, and {} cannot be loaded: {}", kCadLibrary, why));
  if (read == nullptr)
    throw Error(ErrorCode::kUnsupported,
                fmt::format("STEP and IGES are read by Open CASCADE, and {} is not there: install Debian's "
                            "libocct-data-exchange-dev and build findspace with -DFINDSPACE_CAD=ON, or give the part "
                            "as a mesh (STL, 3MF)",
                            kCadLibrary));
  CadProblem problem;
  std::unique_ptr<CadFile> file = read(bytes, ending == ".iges" || ending == ".igs", problem);
  if (!file) raise(problem);
  return file;
}

std::string name_of(const CadFile& file, std::size_t k) {
  return file.name(k).empty() ? file.place_name(k) : file.name(k);
}

std::string names_in(const CadFile& file) {
  constexpr std::size_t kListed = 12;
  std::vector<std::string> names;
  for (std::size_t k = 0; k < file.solids(); ++k)
    if (const std::string name = name_of(file, k); !name.empty() && std::count(names.begin(), names.end(), name) == 0)
      names.push_back(name);
  std::string out;
  for (std::size_t k = 0; k < std::min(names.size(), kListed); ++k) out += (k == 0 ? "" : ", ") + names[k];
  return names.size() > kListed ? out + fmt::format(" and {} more", names.size() - kListed) : out;
}

/// Whether the solid is that part, or in an assembly of that name.
bool is_in(const CadFile& file, std::size_t k, const std::string& name) {
  const std::vector<std::string> assemblies = file.assemblies(k);
  return file.name(k) == name || file.place_name(k) == name ||
         std::find(assemblies.begin(), assemblies.end(), name) != assemblies.end();
}

std::vector<std::size_t> chosen_solids(const CadFile& file, const CadChoice& choice) {
  std::vector<std::size_t> out;
  for (std::size_t k = 0; k < file.solids(); ++k)
    if (!choice.id || is_in(file, k, *choice.id)) out.push_back(k);
  if (out.empty())
    throw Error(ErrorCode::kBadValue, fmt::format("it has no part '{}'; there are {}", *choice.id, names_in(file)));
  if (!choice.index) return out;
  if (*choice.index >= out.size())
    throw Error(ErrorCode::kBadValue,
                fmt::format("\"index\" {} is too large: it has {} solids, counted from 0", *choice.index, out.size()));
  return {out[*choice.index]};
}

}  // namespace

std::vector<CadPart> read_cad(const std::string& bytes, const std::string& ending, ReadContext& context,
                              const Real& scale, const CadChoice& choice) {
  const std::unique_ptr<CadFile> file = open_cad(bytes, ending);
  for (const std::string& note : file->notes()) context.notes.push_back(note);
  std::vector<CadPart> out;
  for (const std::size_t k : chosen_solids(*file, choice)) {
    std::string name = name_of(*file, k);
    const std::string shown = name.empty() ? fmt::format("solid {}", k) : name;
    try {
      out.push_back(SolidOfCad(*file, k, shown, context, scale).part(choice.balls));
      out.back().name = name;
    } catch (const Error& e) {
      throw e.within(shown);
    }
  }
  return out;
}

bool is_cad_ending(std::string_view ending) {
  return ending == ".step" || ending == ".stp" || ending == ".iges" || ending == ".igs";
}

bool has_cad() { return cad_reader() != nullptr; }

}  // namespace findspace::io
