// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/write/draw_rotations.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "io/draw/draw_layout.h"
#include "io/text/put.h"

namespace findspace::io {
namespace {

constexpr double kDialWidth = 300, kRadius = 92, kBand = 16, kDialTop = 74, kLine = 19;
constexpr std::size_t kMostListed = 16;

struct Spot {
  double x, y;
};

class Dial {
 public:
  Dial(double left, double height, const std::vector<DegreeInterval>& angles)
      : angles_(angles), center_{left + kDialWidth / 2, kDialTop + kRadius + 30}, left_(left), height_(height) {}

  double height() const {
    const double lines = double(std::min(angles_.size(), kMostListed + 1)) + 1;
    return std::max(height_, list_top() + lines * kLine + 16);
  }

  std::string svg() {
    put(out_, "<circle cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"none\" stroke=\"#e3e6ea\" stroke-width=\"{}\"/>\n",
        pixels(center_.x), pixels(center_.y), kRadius, kBand);
    for (int d = 0; d < 360; d += 30) tick(d);
    for (const DegreeInterval& i : angles_) band(i);
    for (const DegreeInterval& i : angles_) ends(i);
    list();
    return out_;
  }

 private:
  Spot at(double degrees, double radius) const {
    const double a = degrees * std::numbers::pi / 180;
    return {center_.x + radius * std::cos(a), center_.y - radius * std::sin(a)};
  }
  double list_top() const { return center_.y + kRadius + 62; }

  void tick(int degrees) {
    const Spot p = at(degrees, kRadius + kBand / 2 + 3), q = at(degrees, kRadius + kBand / 2 + 8),
               t = at(degrees, kRadius + kBand / 2 + 21);
    put(out_, "<path d=\"M{} {}L{} {}\" stroke=\"#667\" stroke-width=\"1\"/>\n", pixels(p.x), pixels(p.y), pixels(q.x),
        pixels(q.y));
    put(out_,
        "<text x=\"{}\" y=\"{}\" font-size=\"11\" fill=\"#556\" text-anchor=\"middle\" "
        "font-family=\"sans-serif\">{}°</text>\n",
        pixels(t.x), pixels(t.y + 4), degrees);
  }

  void band(const DegreeInterval& i) {
    if (i.to == i.from) return;
    // In parts of at most 90 degrees, which no viewer can mistake.
    const int parts = int(std::ceil((i.to - i.from) / 90));
    const Spot start = at(i.from, kRadius);
    std::string path = fmt::format("M{} {}", pixels(start.x), pixels(start.y));
    for (int k = 1; k <= parts; ++k) {
      const Spot p = at(i.from + (i.to - i.from) * k / parts, kRadius);
      path += fmt::format("A{0} {0} 0 0 0 {1} {2}", kRadius, pixels(p.x), pixels(p.y));
    }
    put(out_, "<path d=\"{}\" fill=\"none\" stroke=\"#2a9d8f\" stroke-width=\"{}\"/>\n", path, kBand);
  }

  void dot(double degrees, bool full) {
    const Spot p = at(degrees, kRadius);
    put(out_, "<circle cx=\"{}\" cy=\"{}\" r=\"4.5\" style=\"fill:{};stroke:#14665c;stroke-width:1.6\"/>\n",
        pixels(p.x), pixels(p.y), full ? "#14665c" : "#fff");
  }

  void ends(const DegreeInterval& i) {
    if (i.whole()) return;
    dot(i.from, i.from_in);
    if (!i.single() && !i.round) dot(i.to, i.to_in);
  }

  void line(std::size_t row, const std::string& text, bool bold = false) {
    put(out_, "<text x=\"{}\" y=\"{}\" font-size=\"{}\"{} fill=\"#223\" font-family=\"sans-serif\">{}</text>\n",
        pixels(left_ + 24), pixels(list_top() + double(row) * kLine), kFontSize, bold ? " font-weight=\"bold\"" : "",
        text);
  }

  void list() {
    line(0, angles_.empty() ? "No angle" : "Angles that belong", true);
    for (std::size_t k = 0; k < angles_.size(); ++k) {
      if (k == kMostListed) return line(k + 1, fmt::format("and {} more", angles_.size() - k));
      const DegreeInterval& i = angles_[k];
      if (i.single())
        line(k + 1, fmt::format("{}° alone", shown(i.from)));
      else
        line(k + 1,
             fmt::format("{} {}° to {}° {}", i.from_in ? "[" : "(", shown(i.from), shown(i.to), i.to_in ? "]" : ")"));
    }
  }

  const std::vector<DegreeInterval>& angles_;
  Spot center_;
  double left_, height_;
  std::string out_;
};

/// The number of an attribute of the outermost element.
double attribute(const std::string& svg, const char* name) {
  const std::size_t at = svg.find(std::string(" ") + name + "=\"");
  return at == std::string::npos ? 0 : std::strtod(svg.c_str() + at + std::string(name).size() + 3, nullptr);
}

}  // namespace

std::string rotations_svg(const std::string& scene, const std::vector<DegreeInterval>& angles) {
  const double width = attribute(scene, "width"), height = attribute(scene, "height");
  Dial dial(width, height, angles);
  const std::string drawn = dial.svg();
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\">\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n{2}{3}</svg>\n",
      pixels(width + kDialWidth), pixels(dial.height()), scene, drawn);
}

}  // namespace findspace::io
