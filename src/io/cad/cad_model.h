// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What the library of CAD files (cad/, which alone knows Open CASCADE) hands over: solids by name as triangles whose
// corners lie on the true surface, each with a bound of how far the two are apart, in millimetres. Nothing of the
// project is linked into that library, so that the program needs it only where a CAD file is read.
//
// The bound of a triangle T: there is a chain of true faces, one for each triangle, whose sum is the boundary of the
// solid, and a map of each chain to its triangle that moves no point farther than the bound. So the solid and what the
// triangles enclose differ only within the bounds of the triangles (cad/deviation.h). Keywords: B-rep, tessellation,
// chordal deviation, plugin.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace findspace::io {

using CadPlace = std::array<double, 3>;

struct CadFace {
  std::vector<int> corners;  // counter-clockwise from outside; three unless it is flat
  int face = 0;              // of the solid, from 1
  bool flat = false;         // exactly this polygon, or within its plane between a curved edge and its chords
  double bound = 0;          // of a curved face
  CadPlace even{};           // a direction along which the bound is 0: the axis of a cylinder or cone; else 0
};

/// The hull of balls of one radius.
struct CadRounded {
  std::vector<CadPlace> centers;
  double radius = 0;
};

struct CadMesh {
  std::vector<CadPlace> places;
  std::vector<CadFace> faces;
  double bound = 0;  // the largest of the faces
};

enum class CadFault { kNone, kFile, kSyntax, kGeometry, kUnsupported, kMemory };

struct CadProblem {
  CadFault fault = CadFault::kNone;
  std::string message;
};

/// A file that has been read.
class CadFile {
 public:
  virtual ~CadFile() = default;
  virtual std::size_t solids() const = 0;
  /// The name of the part, and that of its place in the assembly; either may be empty.
  virtual std::string name(std::size_t solid) const = 0;
  virtual std::string place_name(std::size_t solid) const = 0;
  /// The names of the assemblies that hold it, and of their places.
  virtual std::vector<std::string> assemblies(std::size_t solid) const = 0;
  /// Where it is exactly that: a ball, a capsule, a box with all edges rounded.
  virtual std::optional<CadRounded> rounded(std::size_t solid) const = 0;
  /// No bound is above `tolerance`; no more than `most` triangles.
  virtual CadProblem mesh(std::size_t solid, double tolerance, std::size_t most, CadMesh& out) const = 0;
  virtual std::vector<std::string> notes() const = 0;
};

/// The one function of the library, by this name: null and a problem where the file cannot be read.
using ReadCad = std::unique_ptr<CadFile>(const std::string& bytes, bool iges, CadProblem& problem);
inline constexpr const char* kReadCad = "findspace_read_cad";
inline constexpr const char* kCadLibrary = "libfindspace_cad.so";

}  // namespace findspace::io
