// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// PLY: a header that describes elements (vertex, face, ...) and their properties, then the data in the same order, as
// text or binary. Read: x y z of vertices and vertex_indices (or vertex_index) of faces; everything else is stepped
// over.
#include "io/mesh/read_mesh_ply.h"

#include <fmt/format.h>

#include <algorithm>

namespace findspace::io {
namespace {

struct Property {
  std::string name, type;
  std::string count;  // the type of the length of a list; empty for a single number
};

struct Element {
  std::string name;
  long count = 0;
  std::vector<Property> properties;
};

enum class Encoding { kText, kLittle, kBig };

struct Header {
  Encoding encoding = Encoding::kText;
  std::vector<Element> elements;
};

Encoding encoding(std::string_view name, const TextLines& lines) {
  if (name == "ascii") return Encoding::kText;
  if (name == "binary_little_endian") return Encoding::kLittle;
  if (name == "binary_big_endian") return Encoding::kBig;
  lines.fail(fmt::format("unknown PLY format '{}'", name));
}

/// A vertex has the properties x, y and z.
void require_places(const Header& header, const TextLines& lines) {
  for (const Element& e : header.elements) {
    if (e.name != "vertex") continue;
    for (const char* name : {"x", "y", "z"}) {
      const auto is = [&](const Property& p) { return p.name == name; };
      if (std::none_of(e.properties.begin(), e.properties.end(), is))
        lines.fail(fmt::format("the vertices have no property {}", name));
    }
  }
}

Header read_header(TextLines& lines) {
  Header header;
  if (!lines.next() || lines.words()[0] != "ply") lines.fail("a PLY file begins with ply");
  while (lines.next()) {
    const auto& w = lines.words();
    if (w[0] == "end_header") {
      require_places(header, lines);
      return header;
    }
    if (w[0] == "format" && w.size() > 1) {
      header.encoding = encoding(w[1], lines);
    } else if (w[0] == "element" && w.size() == 3) {
      header.elements.push_back({std::string(w[1]), lines.integer(w[2]), {}});
    } else if (w[0] == "property" && !header.elements.empty() && (w.size() == 3 || (w.size() == 5 && w[1] == "list"))) {
      Property p{std::string(w.back()), std::string(w[w.size() - 2]), w.size() == 5 ? std::string(w[2]) : ""};
      header.elements.back().properties.push_back(std::move(p));
    }
  }
  lines.fail("the header does not end");
}

/// The numbers of the data part one after another, from text or from bytes. Text keeps the decimals as they are
/// written.
class Data {
 public:
  Data(const std::string& bytes, TextLines& lines, Encoding encoding)
      : bytes_(bytes), lines_(lines), encoding_(encoding), at_(lines.offset()) {}

  std::string_view word() {
    while (next_ >= words_.size()) {
      if (!lines_.next()) lines_.fail("the data end too early");
      words_ = lines_.words();
      next_ = 0;
    }
    return words_[next_++];
  }
  bool text() const { return encoding_ == Encoding::kText; }
  double number(const std::string& type) {
    if (type == "char" || type == "int8") return take<std::int8_t>();
    if (type == "uchar" || type == "uint8") return take<std::uint8_t>();
    if (type == "short" || type == "int16") return take<std::int16_t>();
    if (type == "ushort" || type == "uint16") return take<std::uint16_t>();
    if (type == "int" || type == "int32") return take<std::int32_t>();
    if (type == "uint" || type == "uint32") return take<std::uint32_t>();
    if (type == "float" || type == "float32") return static_cast<double>(take<float>());
    if (type == "double" || type == "float64") return take<double>();
    throw Error(ErrorCode::kSyntax, fmt::format("unknown PLY type '{}'", type));
  }
  long integer(const std::string& type) { return text() ? lines_.integer(word()) : static_cast<long>(number(type)); }

 private:
  template <class T>
  T take() {
    const T value = number_at<T>(bytes_, at_, encoding_ == Encoding::kBig);
    at_ += sizeof(T);
    return value;
  }
  const std::string& bytes_;
  TextLines& lines_;
  Encoding encoding_;
  std::size_t at_, next_ = 0;
  std::vector<std::string_view> words_;
};

void read_vertex(const Element& element, Data& data, TextLines& lines, MeshBuilder& out) {
  std::string_view words[3];
  double numbers[3] = {0, 0, 0};
  for (const Property& p : element.properties) {
    const int axis = p.name == "x" ? 0 : p.name == "y" ? 1 : p.name == "z" ? 2 : -1;
    if (!p.count.empty()) lines.fail("a vertex with a list is not read");
    if (data.text()) {
      const std::string_view w = data.word();
      if (axis >= 0) words[axis] = w;
    } else {
      const double v = data.number(p.type);
      if (axis >= 0) numbers[axis] = v;
    }
  }
  if (data.text())
    out.vertex(lines, words[0], words[1], words[2]);
  else
    out.vertex(numbers[0], numbers[1], numbers[2]);
}

void read_other(const Element& element, Data& data, TextLines& lines, MeshBuilder& out) {
  for (const Property& p : element.properties) {
    const bool faces = element.name == "face" && (p.name == "vertex_indices" || p.name == "vertex_index");
    const long count = p.count.empty() ? 1 : data.integer(p.count);
    std::vector<int> face;
    for (long i = 0; i < count; ++i) {
      if (faces)
        face.push_back(out.index(lines, data.integer(p.type)));
      else if (data.text())
        data.word();
      else
        data.number(p.type);
    }
    if (faces) out.face(std::move(face));
  }
}

}  // namespace

void read_ply(const std::string& bytes, MeshBuilder& out) {
  TextLines lines(bytes);
  const Header header = read_header(lines);
  Data data(bytes, lines, header.encoding);
  for (const Element& element : header.elements) {
    if (element.properties.empty()) continue;  // no data, however many it counts
    for (long i = 0; i < element.count; ++i) {
      if (element.name == "vertex")
        read_vertex(element, data, lines, out);
      else
        read_other(element, data, lines, out);
    }
  }
}

}  // namespace findspace::io
