// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/mesh/mesh_3mf.h"

#include <findspace/error.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <new>
#include <pugixml.hpp>
#include <set>
#include <sstream>

#include "io/mesh/mesh_transform.h"
#include "io/mesh/zip_archive.h"

namespace findspace::io {
namespace {

using exact::Real;

constexpr int kMostDepth = 64;
constexpr const char* kModel = "3D/3dmodel.model";
constexpr const char* kModelType = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel";
constexpr const char* kCore = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02";

[[noreturn]] void bad_value(const std::string& what) { throw Error(ErrorCode::kBadValue, what); }

Real decimal(const pugi::xml_node& node, const char* name) {
  const pugi::xml_attribute value = node.attribute(name);
  if (!value) bad_value(fmt::format("a <{}> has no {}", node.name(), name));
  try {
    return Real::parse_decimal(value.value());
  } catch (const Error&) {
    bad_value(fmt::format("a <{}> has the {} '{}', which is not a number", node.name(), name, value.value()));
  }
}

long whole(const pugi::xml_node& node, const char* name) {
  const std::string_view text = node.attribute(name).value();
  long value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || value < 0)
    bad_value(fmt::format("a <{}> has the {} '{}', which is not an index", node.name(), name, text));
  return value;
}

MeshTransform transform(const pugi::xml_node& node) {
  MeshTransform out;
  const pugi::xml_attribute given = node.attribute("transform");
  if (!given) return out;
  std::istringstream words(given.value());
  std::string word;
  int count = 0;
  for (; words >> word; ++count) {
    if (count == 12) break;
    try {
      out.row[static_cast<std::size_t>(count / 3)][static_cast<std::size_t>(count % 3)] = Real::parse_decimal(word);
    } catch (const Error&) {
      bad_value(fmt::format("a transform has '{}', which is not a number", word));
    }
  }
  if (count != 12 || words >> word) bad_value("a transform has twelve numbers");
  return out;
}

class Reader {
 public:
  Reader(const pugi::xml_node& model, MeshBuilder& out) : out_(out) {
    for (const pugi::xml_node& object : model.child("resources").children("object")) {
      if (!objects_.emplace(whole(object, "id"), object).second)
        bad_value(fmt::format("two objects have the id {}", object.attribute("id").value()));
    }
  }

  void build(const pugi::xml_node& model) {
    for (const pugi::xml_node& item : model.child("build").children("item"))
      object(whole(item, "objectid"), transform(item), 0);
    if (out_.mesh().faces.empty()) bad_value("nothing with triangles is built");
  }

 private:
  void object(long id, const MeshTransform& placed, int depth) {
    const auto found = objects_.find(id);
    if (found == objects_.end()) bad_value(fmt::format("there is no object {}", id));
    if (depth > kMostDepth) bad_value(fmt::format("object {} is a component of itself, or of too many", id));
    if (const pugi::xml_node mesh = found->second.child("mesh")) {
      if (!placed_.insert(id).second) charge_again(mesh);
      return triangles(mesh, placed);
    }
    for (const pugi::xml_node& part : found->second.child("components").children("component")) {
      if (++components_ > kMostComponents) bad_value("there are more than 100,000 components");
      object(whole(part, "objectid"), placed.after(transform(part)), depth + 1);
    }
  }

  /// What one file repeats is not bounded by its length.
  void charge_again(const pugi::xml_node& mesh) {
    const auto count = [](const pugi::xml_node& list) { return std::distance(list.begin(), list.end()); };
    const auto parts = count(mesh.child("vertices")) + count(mesh.child("triangles"));
    out_.charge(kAgain * static_cast<std::uint64_t>(parts), "placing one mesh so often");
  }

  void triangles(const pugi::xml_node& mesh, const MeshTransform& placed) {
    const int sense = placed.sense();
    if (sense == 0) bad_value("a transform flattens what it places");
    const auto first = static_cast<long>(out_.size());
    for (const pugi::xml_node& v : mesh.child("vertices").children("vertex"))
      out_.vertex(placed.apply({decimal(v, "x"), decimal(v, "y"), decimal(v, "z")}));
    const auto end = static_cast<long>(out_.size());
    for (const pugi::xml_node& t : mesh.child("triangles").children("triangle")) {
      std::vector<int> face;
      for (const char* corner : {"v1", "v2", "v3"}) {
        const long v = first + whole(t, corner);
        if (v >= end) bad_value("a triangle refers to a vertex that is not there");
        face.push_back(static_cast<int>(v));
      }
      if (sense < 0) std::reverse(face.begin(), face.end());
      out_.face(std::move(face));
    }
  }

  static constexpr int kMostComponents = 100000;
  static constexpr std::uint64_t kAgain = 10;  // units for a vertex or a triangle
  MeshBuilder& out_;
  std::map<long, pugi::xml_node> objects_;
  std::set<long> placed_;
  int components_ = 0;
};

pugi::xml_node root(pugi::xml_document& document, std::string_view xml) {
  const pugi::xml_parse_result parsed = document.load_buffer(xml.data(), xml.size());
  if (parsed.status == pugi::status_out_of_memory) throw std::bad_alloc();
  if (!parsed) throw Error(ErrorCode::kSyntax, fmt::format("the model is not XML: {}", parsed.description()));
  const pugi::xml_node model = document.child("model");
  if (!model) throw Error(ErrorCode::kSyntax, "the model file has no <model>");
  return model;
}

/// The member that the package names as its model.
std::string model_name(const ZipArchive& archive, ReadContext& context) {
  const auto relations = archive.member("_rels/.rels", context);
  pugi::xml_document document;
  if (!relations || !document.load_buffer(relations->data(), relations->size())) return kModel;
  for (const pugi::xml_node& r : document.child("Relationships").children("Relationship")) {
    if (std::string_view(r.attribute("Type").value()) != kModelType) continue;
    std::string target = r.attribute("Target").value();
    return target.starts_with('/') ? target.substr(1) : target;
  }
  return kModel;
}

Real millimetres(std::string_view unit) {
  static const std::map<std::string_view, Real> kUnits{{"", Real(1)},
                                                       {"millimeter", Real(1)},
                                                       {"micron", Real::ratio(1, 1000)},
                                                       {"centimeter", Real(10)},
                                                       {"inch", Real::ratio(254, 10)},
                                                       {"foot", Real::ratio(3048, 10)},
                                                       {"meter", Real(1000)}};
  const auto found = kUnits.find(unit);
  if (found == kUnits.end()) bad_value(fmt::format("the model has the unknown unit '{}'", unit));
  return found->second;
}

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
      kModel, kModelType);
  return zip_bytes({{"[Content_Types].xml", types}, {"_rels/.rels", relations}, {kModel, model}});
}

void put_mesh(pugi::xml_node mesh, const Surface& s, double factor) {
  pugi::xml_node vertices = mesh.append_child("vertices"), triangles = mesh.append_child("triangles");
  for (const auto& v : s.vertices) {
    pugi::xml_node node = vertices.append_child("vertex");
    const char* names[3] = {"x", "y", "z"};
    for (std::size_t k = 0; k < 3; ++k) node.append_attribute(names[k]) = fmt::format("{}", v[k] * factor).c_str();
  }
  for (const auto& face : s.faces) {
    for (std::size_t i = 1; i + 1 < face.size(); ++i) {
      pugi::xml_node node = triangles.append_child("triangle");
      node.append_attribute("v1") = face[0];
      node.append_attribute("v2") = face[i];
      node.append_attribute("v3") = face[i + 1];
    }
  }
}

/// Column by column, for points are rows there; then the shift.
std::string transform_text(const Assembly::Copy& copy, double factor) {
  std::string text;
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t i = 0; i < 3; ++i) text += fmt::format("{} ", copy.rotation[i][j]);
  return text + fmt::format("{} {} {}", copy.at[0] * factor, copy.at[1] * factor, copy.at[2] * factor);
}

}  // namespace

Model3mf open_3mf(std::string_view bytes, ReadContext& context) {
  const ZipArchive archive(bytes);
  auto xml = archive.member(model_name(archive, context), context);
  if (!xml) throw Error(ErrorCode::kFile, "the package has no 3D model");
  pugi::xml_document document;
  const pugi::xml_node model = root(document, *xml);
  const std::string_view required = model.attribute("requiredextensions").value();
  if (!required.empty()) bad_value(fmt::format("the model requires the extension '{}', which is not read", required));
  const Real unit = millimetres(model.attribute("unit").value());
  return {std::move(*xml), unit};
}

void read_3mf(const Model3mf& model, MeshBuilder& out) {
  pugi::xml_document document;
  const pugi::xml_node top = root(document, model.xml);
  Reader(top, out).build(top);
}

std::string text_3mf(const Assembly& assembly, std::string_view title, std::string_view unit) {
  static const std::map<std::string_view, const char*> kNames{
      {"", "millimeter"}, {"mm", "millimeter"}, {"um", "micron"}, {"cm", "centimeter"},
      {"m", "meter"},     {"in", "inch"},       {"mil", "inch"}};
  const double factor = unit == "mil" ? 0.001 : 1;  // no sign: a unit
  pugi::xml_document document;
  pugi::xml_node model = document.append_child("model");
  model.append_attribute("unit") = kNames.at(unit);
  model.append_attribute("xmlns") = kCore;
  pugi::xml_node meta = model.append_child("metadata");
  meta.append_attribute("name") = "Title";
  meta.text() = std::string(title).c_str();
  pugi::xml_node resources = model.append_child("resources"), build = model.append_child("build");
  int id = 0;
  for (const Assembly::Kind& kind : assembly.kinds) {
    pugi::xml_node object = resources.append_child("object");
    object.append_attribute("id") = ++id;
    object.append_attribute("type") = "model";
    if (!kind.name.empty()) object.append_attribute("name") = kind.name.c_str();
    put_mesh(object.append_child("mesh"), kind.surface, factor);
  }
  for (const Assembly::Copy& copy : assembly.copies) {
    pugi::xml_node item = build.append_child("item");
    item.append_attribute("objectid") = static_cast<int>(copy.kind) + 1;
    if (copy.is_moved()) item.append_attribute("transform") = transform_text(copy, factor).c_str();
    if (!copy.name.empty()) item.append_attribute("partnumber") = copy.name.c_str();
  }
  std::ostringstream xml;
  document.save(xml, "", pugi::format_raw);
  return bytes_3mf(xml.str());
}

}  // namespace findspace::io
