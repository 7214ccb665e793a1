// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/write/write_poses.h"

#include <fmt/format.h>

#include "io/draw/draw_canvas.h"
#include "io/write/write_json.h"
#include "plane/query/summary.h"
#include "plane/query/topology.h"

namespace findspace::io {
namespace {

std::string region(const plane::Region& r, const exact::Real& step, std::string_view unit) {
  std::string text = region_json(r, plane::summarize(r, step), step, unit);
  text.pop_back();  // the last line break
  return text;
}

constexpr const char* kScript = R"(
const pages = [...document.querySelectorAll('section')], slider = document.querySelector('input');
function show(k) {
  k = (k + pages.length) % pages.length;
  pages.forEach((p, i) => p.hidden = i !== k);
  slider.value = k;
  document.querySelector('output').textContent = (k + 1) + ' of ' + pages.length;
}
document.querySelector('nav').hidden = false;
slider.max = pages.length - 1;
slider.oninput = () => show(+slider.value);
document.querySelector('#back').onclick = () => show(+slider.value - 1);
document.querySelector('#on').onclick = () => show(+slider.value + 1);
document.onkeydown = e => { if (e.key === 'ArrowLeft') show(+slider.value - 1); if (e.key === 'ArrowRight') show(+slider.value + 1); };
show(0);
)";

}  // namespace

std::string poses_json(const planning::PoseStack& stack, const exact::Real& step, std::string_view unit) {
  std::string out = fmt::format("{{\"poses\": [");
  const char* between = "\n";
  bool empty = true;
  for (const planning::PoseSlice& s : stack.slices) {
    empty = empty && plane::is_empty(s.outer ? *s.outer : s.region);
    out += fmt::format("{}{{\"angle\": {}, \"rounded\": {{\"points\": {}, \"largest\": {}}}, \"region\": {}", between,
                       json_number(s.degrees.to_double()), s.rounding.points,
                       json_number(s.rounding.largest * step.to_double()), region(s.region, step, unit));
    out += s.outer ? fmt::format(", \"outer\": {}}}", region(*s.outer, step, unit)) : "}";
    between = ",\n";
  }
  out += "],\n\"sectors\": [";
  between = "\n";
  for (const planning::PoseSector& s : stack.sectors) {
    out += fmt::format("{}{{\"from\": {}, \"to\": {}, \"bound\": {}, \"inner\": {}, \"outer\": {}}}", between,
                       json_number(s.from.to_double()), json_number(s.to.to_double()), json_number(s.bound),
                       region(s.inner, step, unit), region(s.outer, step, unit));
    between = ",\n";
  }
  return out + fmt::format("],\n\"empty\": {}}}\n", empty);
}

std::string pages_html(std::string_view title, const std::vector<Page>& pages) {
  std::string out = fmt::format(
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{0}</title>\n"
      "<style>body{{font:15px sans-serif;margin:18px;color:#223}}nav{{margin:8px "
      "0}}input{{width:420px;vertical-align:middle}}"
      "button{{font-size:15px}}</style></head><body>\n<h1 "
      "style=\"font-size:20px\">{0}</h1>\n"
      "<nav hidden><button id=\"back\">&#9664;</button> <input type=\"range\" min=\"0\" value=\"0\" "
      "aria-label=\"page\"> "
      "<button id=\"on\">&#9654;</button> <output></output></nav>\n",
      xml_escaped(title));
  for (const Page& p : pages)  // the picture has the title, too
    out += fmt::format("<section aria-label=\"{}\">\n{}</section>\n", xml_escaped(p.title), p.svg);
  return out + "<script>" + kScript + "</script></body></html>\n";
}

}  // namespace findspace::io
