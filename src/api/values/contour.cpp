// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "findspace/contour.h"

namespace findspace {

Contour& Contour::line_to(Point end) {
  steps_.push_back({Step::Kind::kLine, std::move(end), {0, 0}});
  return *this;
}

Contour& Contour::bulge_to(Number bulge, Point end) {
  steps_.push_back({Step::Kind::kBulge, std::move(end), {std::move(bulge), 0}});
  return *this;
}

Contour& Contour::arc_through(Point middle, Point end) {
  steps_.push_back({Step::Kind::kThrough, std::move(end), std::move(middle)});
  return *this;
}

Contour& Contour::arc_about(Point center, Point end, bool counterclockwise) {
  const Step::Kind kind = counterclockwise ? Step::Kind::kAboutLeft : Step::Kind::kAboutRight;
  steps_.push_back({kind, std::move(end), std::move(center)});
  return *this;
}

}  // namespace findspace
