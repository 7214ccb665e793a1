// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What the reports on Phi-functions of the plane (write_planar_phi.h) and of space (write_phi.h) have in common.
#pragma once

#include <string>

#include "io/write/json_text.h"
#include "io/write/write_phi.h"

namespace findspace::io {

/// The members of one pair, or "parts" with those of each.
template <class Report, class PutPair>
void put_pairs(std::string& out, const Report& r, PutPair&& put_pair) {
  if (r.phi->pair_count() == 1) return put_pair(out, r.phi->pair(0), r.step);
  out += "\"parts\":[";
  for (int k = 0; k < r.phi->pair_count(); ++k) {
    put(out, "{}\n{{\"first\":{},\"second\":{},", k == 0 ? "" : ",", k / r.parts_second, k % r.parts_second);
    put_pair(out, r.phi->pair(k), r.step);
    out += "}";
  }
  out += "]";
}

/// `, "at": {...`, without the closing brace; coordinates separated by commas.
template <class Report>
void put_at(std::string& out, const Report& r, const std::string& position, const std::string& gradient) {
  const double step = r.step.to_double();
  const auto& at = r.value->at;
  put(out, ",\n\"at\":{{\"position\":[{}],\"phi\":{},\"normalised\":{},\"distance\":{},\"state\":\"{}\",", position,
      at.phi * step, at.normalised * step, at.distance * step, state_name(at.state));
  put(out, "\"gradient\":[{}],\"active\":[{}],\"pair\":[{},{}]", gradient, fmt::join(at.active, ","),
      r.value->pair / r.parts_second, r.value->pair % r.parts_second);
}

/// A table for each pair, and the value at `position`, if one was asked for.
template <class Report, class PutTable>
std::string pairs_table(const Report& r, const std::string& position, PutTable&& put_table) {
  std::string out;
  put(out, "Phi-function of {} and {}, {} translated by u: {} - {}\n", r.first, r.second, r.second, r.first, r.second);
  for (int k = 0; k < r.phi->pair_count(); ++k) {
    if (r.phi->pair_count() > 1)
      put(out, "\npart {} of {}, part {} of {}\n", k / r.parts_second + 1, r.first, k % r.parts_second + 1, r.second);
    put_table(out, r.phi->pair(k), r.step);
  }
  if (!r.value) return out;
  const double step = r.step.to_double();
  const auto& at = r.value->at;
  put(out, "\nat ({}): {}, Phi = {}", position, state_name(at.state), at.phi * step);
  if (at.state == space::State::kApart) put(out, ", distance {}", at.distance * step);
  return out + "\n" + limits_table(r.limits);
}

}  // namespace findspace::io
