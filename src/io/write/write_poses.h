// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A stack of maps, one an angle, with the certified regions of the sectors between: as JSON (docs/results.md), and as
// one HTML file with all pages in it, nothing loaded from elsewhere. Keywords: multi-page SVG, flip book.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "exact/number/real.h"
#include "planning/pose/pose_stack.h"

namespace findspace::io {

std::string poses_json(const planning::PoseStack& stack, const exact::Real& step, std::string_view unit);

struct Page {
  std::string title;
  std::string svg;
};

/// Pages to step through by button, slider or arrow key; without scripts all are shown one below the other.
std::string pages_html(std::string_view title, const std::vector<Page>& pages);

}  // namespace findspace::io
