// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// How far a triangle of a face may be from the face: the bound of deviation.h, with the distance of its corners from
// the surface and of the boundary curve from its chord. At a pole, where a whole line of parameters is one point, a
// triangle takes that point at the parameter in its middle. Guarantee: proved, as deviation.h says. Keywords: chordal
// error.
#pragma once

#include "face_mesh.h"

namespace findspace::cad {

/// What one triangle promises.
struct Promise {
  double bound = 0, slack = 0;  // slack: how much of it the boundary takes
  int longest = 0;              // side, as the bound measures
  bool even = false;
};

/// `places`: of the corners of the solid.
Promise promise_of(const FaceMesh& f, const Triangle& t, const std::vector<io::CadPlace>& places);

/// The greatest distance of its corners from the surface; a pole is there for any free parameter.
double off_surface(const FaceMesh& f, const Triangle& t, const std::vector<io::CadPlace>& places);

/// The direction along which a straight-lined surface is a linear function of its parameters; 0 where there is none.
io::CadPlace even_direction(const Handle(Geom_Surface) & surface);

}  // namespace findspace::cad
