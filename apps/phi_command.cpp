// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "phi_command.h"

#include <findspace/error.h>
#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <numeric>

#include "io/write_phi.h"
#include "space/closed_forms.h"
#include "space/convex_parts.h"

namespace findspace::app {
namespace {

using exact::Real;

/// Three decimals, separated by commas.
space::RealVector parse_position(std::string_view text) {
  space::RealVector at;
  std::size_t begin = 0;
  for (int k = 0; k < 3; ++k) {
    const std::size_t end = k == 2 ? text.size() : text.find(',', begin);
    if (end == std::string_view::npos)
      throw Error(ErrorCode::kUsage, fmt::format("--at wants three numbers x,y,z, not '{}'", text));
    try {
      at[k] = Real::parse_decimal(text.substr(begin, end - begin));
    } catch (const Error&) {
      throw Error(ErrorCode::kUsage, fmt::format("--at wants three numbers x,y,z, not '{}'", text));
    }
    begin = end + 1;
  }
  return at;
}

void note_parts(const std::string& name, const space::ConvexParts& parts, std::vector<std::string>& notes) {
  if (parts.parts.size() > 1) notes.push_back(fmt::format("{}: {} convex parts", name, parts.parts.size()));
  if (parts.rounded > 0) {
    notes.push_back(fmt::format("{}: {} vertices of convex parts rounded, by at most {:.3g} grid steps", name,
                                parts.rounded, parts.moved));
  }
}

/// Two balls: the closed forms. No facets.
std::string balls_json(const space::Solid& a, const space::Solid& b, const io::Scene& scene,
                       const PhiRequest& request) {
  const Real step = scene.grid.step();
  const Real reach = (a.radius + b.radius) * step;
  std::string text = fmt::format("{{\"form\":\"balls\",\"vertices\":[],\"facets\":[],\"radius\":{}", reach.text());
  if (request.at) {
    const space::RealVector u = parse_position(*request.at);
    const auto &p = a.mesh.vertices[0], &q = b.mesh.vertices[0];
    const space::RealVector d{u[0] + Real(q.x - p.x) * step, u[1] + Real(q.y - p.y) * step,
                              u[2] + Real(q.z - p.z) * step};
    const Real square = d[0] * d[0] + d[1] * d[1] + d[2] * d[2] - reach * reach;
    // d - R = (d^2 - R^2) / (d + R), without cancellation.
    const double length = std::sqrt((square + reach * reach).to_double());
    const double phi = square.to_double() / (length + reach.to_double());
    const int s = square.sign();
    const auto gradient = [&](int k) { return length > 0 ? d[k].to_double() / length : k == 0 ? 1.0 : 0.0; };
    text += fmt::format(
        ",\n\"at\":{{\"position\":[{},{},{}],\"phi\":{},\"square\":{},\"distance\":{},\"state\":\"{}\",\"gradient\":[{}"
        ",{},{}]}}",
        u[0].text(), u[1].text(), u[2].text(), phi, square.text(), std::max(phi, 0.0),
        s < 0   ? "overlap"
        : s > 0 ? "apart"
                : "contact",
        gradient(0), gradient(1), gradient(2));
  }
  return text + "}\n";
}

void write_outputs(const PhiRequest& request, const io::PhiReport& report) {
  const std::string title = fmt::format("Phi-function of {} and {}", report.first, report.second);
  for (const std::filesystem::path& path : request.outputs) {
    const std::string ending = path.extension().string();
    const std::string text = ending == ".json"  ? io::phi_json(report)
                             : ending == ".txt" ? io::phi_table(report)
                                                : io::surface_text(io::phi_surface(report), title, ending, "");
    std::ofstream file(path, std::ios::binary);
    file << text;
    file.close();
    if (!file) throw Error(ErrorCode::kFile, "cannot write the file", path.string());
  }
}

}  // namespace

CommandResult run_phi(const io::Scene& scene, const PhiRequest& request) {
  const plane::ShapePtr a = scene.shape(request.first), b = scene.shape(request.second);
  if (scene.dimension != 3) throw Error(ErrorCode::kUnsupported, "phi needs 3D shapes: polytopes, or unions of them");
  CommandResult result;
  const space::Solid *ball_a = space::solid_of(*a), *ball_b = space::solid_of(*b);
  if (ball_a && ball_b && ball_a->form == space::Solid::Form::kBall && ball_b->form == space::Solid::Form::kBall) {
    result.text = balls_json(*ball_a, *ball_b, scene, request);
    return result;
  }
  const space::ConvexParts p = space::convex_parts(*a), q = space::convex_parts(*b);
  note_parts(request.first, p, result.notes);
  note_parts(request.second, q, result.notes);
  const std::int64_t scale = std::lcm(p.scale, q.scale);
  const space::PhiUnion phi(space::at_scale(p, scale), space::at_scale(q, scale));
  io::PhiReport report{request.first,
                       request.second,
                       &phi,
                       static_cast<int>(p.parts.size()),
                       static_cast<int>(q.parts.size()),
                       scene.grid.step() / Real(scale),
                       {},
                       std::nullopt};
  if (request.at) {
    space::RealVector u = parse_position(*request.at);
    for (int k = 0; k < 3; ++k) {
      report.at[k] = u[k];
      u[k] = u[k] / report.step;
    }
    report.value = phi.at(u);
  }
  write_outputs(request, report);
  if (request.json)
    result.text = io::phi_json(report);
  else if (request.outputs.empty())
    result.text = io::phi_table(report);
  return result;
}

}  // namespace findspace::app
