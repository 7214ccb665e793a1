// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "io/nesting/fault_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace findspace::io {

using packing::Fault;

std::string item_name(const packing::Problem& problem, const packing::Layout& layout, std::size_t item) {
  const packing::Placed& placed = layout.items[item];
  return fmt::format("{}#{}", problem.parts[placed.part].name, placed.copy);
}

std::string fault_text(const packing::Problem& problem, const packing::Layout& layout, const packing::Fault& fault) {
  const auto item = [&](std::size_t i) { return item_name(problem, layout, i); };
  switch (fault.kind) {
    case Fault::Kind::kOverlap:
      return fmt::format("{} and {} overlap by {:.3g} near ({:.6g}, {:.6g})", item(fault.first), item(fault.second),
                         fault.depth, fault.x, fault.y);
    case Fault::Kind::kGap:
      return fmt::format("{} and {} are too near each other, near ({:.6g}, {:.6g})", item(fault.first),
                         item(fault.second), fault.x, fault.y);
    case Fault::Kind::kCondition:
      return fmt::format("a condition of {} and {} does not hold, near ({:.6g}, {:.6g})", item(fault.first),
                         item(fault.second), fault.x, fault.y);
    case Fault::Kind::kOutside:
      if (const std::size_t sheet = layout.items[fault.first].sheet,
          count = std::max<std::size_t>(layout.sheets.size(), 1);
          sheet >= count)
        return fmt::format("{} stands on sheet {}, and there {} {}, counted from 0", item(fault.first), sheet,
                           count == 1 ? "is" : "are", count);
      if (fault.depth <= 0)  // in a frame or a hole: no depth is measured
        return fmt::format("{} is outside the sheet or its edge, or in a hole of it", item(fault.first));
      return fmt::format("{} is outside the strip, the sheet or its edges by {:.3g}", item(fault.first), fault.depth);
    case Fault::Kind::kAngle:
      return fmt::format("{} stands at an angle that is not allowed", item(fault.first));
    case Fault::Kind::kZone:
      return fmt::format("{} lies in a zone that keeps it out, or leaves one that holds it", item(fault.first));
    case Fault::Kind::kFixed:
      return fmt::format("a fixed {} does not stand at ({:.6g}, {:.6g})", problem.parts[fault.first].name, fault.x,
                         fault.y);
    case Fault::Kind::kSheets:
      return fmt::format("sheet {}: {} too many", problem.sheets[fault.first].name, fault.depth);
    case Fault::Kind::kCount:
      break;
  }
  const std::string& part = problem.parts[fault.first].name;
  return fault.depth > 0 ? fmt::format("part {}: {} too many", part, fault.depth)
                         : fmt::format("part {}: {} missing", part, -fault.depth);
}

}  // namespace findspace::io
