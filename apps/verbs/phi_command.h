// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The verb `phi` in the plane and in space, and what the two share: the limits of --min-distance and --max-distance.
#pragma once

#include <functional>
#include <vector>

#include "common/session.h"
#include "io/write/write_phi.h"

namespace findspace::app {

Outcome planar_phi(const Session& session);
Outcome space_phi(const Session& session);

/// The limits asked for. `sign(rho)` is that of Phi - rho with Phi normalised, `normalised` its value; rho in the
/// scene's unit. Throws Error(kUsage).
std::vector<io::PhiLimit> phi_limits(const Options& options, double normalised,
                                     const std::function<int(const exact::Real&)>& sign);

}  // namespace findspace::app
