// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include <fmt/format.h>

#include <iterator>
#include <map>

#include "io/draw/draw_canvas.h"
#include "io/mesh/mesh_3mf.h"
#include "io/mesh/zip_archive.h"

namespace findspace::io {
namespace {

constexpr const char* kCore = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02";

std::string bytes_3mf(const std::string& model) {
  const std::string types =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<Types "
      "xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\"><Default Extension=\"rels\" "
      "ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/><Default Extension=\"model\" "
      "ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/></Types>\n";
  const std::string relations = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<Relationships "
      "xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\"><Relationship Target=\"/{}\" Id=\"rel0\" "
      "Type=\"{}\"/></Relationships>\n",
      kModel3mf, kModelType3mf);
  return zip_bytes({{"[Content_Types].xml", types}, {"_rels/.rels", relations}, {kModel3mf, model}});
}

void put_model_mesh(std::string& xml, const Surface& s, double factor) {
  auto end = std::back_inserter(xml);
  xml += "<mesh><vertices>";
  for (const auto& v : s.vertices)
    fmt::format_to(end, "<vertex x=\"{}\" y=\"{}\" z=\"{}\"/>", v[0] * factor, v[1] * factor, v[2] * factor);
  xml += "</vertices><triangles>";
  for (const auto& face : s.faces)
    for (std::size_t i = 1; i + 1 < face.size(); ++i)
      fmt::format_to(end, "<triangle v1=\"{}\" v2=\"{}\" v3=\"{}\"/>", face[0], face[i], face[i + 1]);
  xml += "</triangles></mesh>";
}

/// Column by column, for points are rows there; then the shift.
std::string transform_text(const Assembly::Copy& copy, double factor) {
  std::string text;
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t i = 0; i < 3; ++i) text += fmt::format("{} ", copy.rotation[i][j]);
  return text + fmt::format("{} {} {}", copy.at[0] * factor, copy.at[1] * factor, copy.at[2] * factor);
}

/// name="value", or nothing of an empty value.
std::string attribute(const char* name, const std::string& value) {
  return value.empty() ? "" : fmt::format(" {}=\"{}\"", name, xml_escaped(value));
}

}  // namespace

std::string text_3mf(const Assembly& assembly, std::string_view title, std::string_view unit) {
  static const std::map<std::string_view, const char*> kNames{
      {"", "millimeter"}, {"mm", "millimeter"}, {"um", "micron"}, {"cm", "centimeter"},
      {"m", "meter"},     {"in", "inch"},       {"mil", "inch"}};
  const double factor = unit == "mil" ? 0.001 : 1;  // no sign: a unit
  std::string xml = fmt::format(
      "<?xml version=\"1.0\"?><model unit=\"{}\" xmlns=\"{}\"><metadata name=\"Title\">{}</metadata><resources>",
      kNames.at(unit), kCore, xml_escaped(title));
  int id = 0;
  for (const Assembly::Kind& kind : assembly.kinds) {
    xml += fmt::format("<object id=\"{}\" type=\"model\"{}>", ++id, attribute("name", kind.name));
    put_model_mesh(xml, kind.surface, factor);
    xml += "</object>";
  }
  xml += "</resources><build>";
  for (const Assembly::Copy& copy : assembly.copies) {
    const std::string transform = copy.is_moved() ? transform_text(copy, factor) : "";
    xml += fmt::format("<item objectid=\"{}\"{}{}/>", copy.kind + 1, attribute("transform", transform),
                       attribute("partnumber", copy.name));
  }
  return bytes_3mf(xml + "</build></model>");
}

}  // namespace findspace::io
