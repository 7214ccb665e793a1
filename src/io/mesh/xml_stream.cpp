// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/mesh/xml_stream.h"

#include <expat.h>
#include <findspace/error.h>
#include <fmt/format.h>

#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <new>

namespace findspace::io {
namespace {

/// The memory of this thread's parsers. Expat keeps all names, and whole what it has begun to read.
class ParserMemory {
 public:
  static void* take(std::size_t size) { return retake(nullptr, size); }
  static void* retake(void* block, std::size_t size) {
    const std::size_t before = block ? size_of(block) : 0;
    if (size > kMost || used_ - before > kMost - size) return nullptr;
    void* const whole = std::realloc(block ? start_of(block) : nullptr, kHead + size);
    if (!whole) return nullptr;
    std::memcpy(whole, &size, sizeof size);
    used_ += size - before;
    return static_cast<char*>(whole) + kHead;
  }
  static void give_back(void* block) {
    if (!block) return;
    used_ -= size_of(block);
    std::free(start_of(block));
  }

 private:
  static constexpr std::size_t kMost = std::size_t{32} << 20, kHead = alignof(std::max_align_t);
  static void* start_of(void* block) { return static_cast<char*>(block) - kHead; }
  static std::size_t size_of(void* block) {
    std::size_t size = 0;
    std::memcpy(&size, start_of(block), sizeof size);
    return size;
  }
  static thread_local std::size_t used_;
};
thread_local std::size_t ParserMemory::used_ = 0;

}  // namespace

const char* xml_attribute(XmlAttributes attributes, const char* name) {
  for (; *attributes; attributes += 2)
    if (std::strcmp(*attributes, name) == 0) return attributes[1];
  return nullptr;
}

namespace {

/// Whatever the declaration says, a byte order mark tells UTF-16, and texts that name UTF-16 are often in UTF-8. In all
/// other encodings names and numbers are ASCII.
const char* encoding_of(std::string_view text) {
  const std::string_view declaration = text.substr(0, text.find('>'));
  const std::size_t at = declaration.find("encoding");
  if (declaration.find("<?xml") == declaration.npos || at == declaration.npos) return "UTF-8";
  const std::string_view name = declaration.substr(at);
  return name.find("UTF") != name.npos || name.find("utf") != name.npos ? "UTF-8" : "ISO-8859-1";
}

}  // namespace

template <class Told>
void XmlStream::guarded(Told told) {
  if (thrown_) return;
  try {
    told();
  } catch (const Error& e) {
    thrown_ = std::make_exception_ptr(e.within(place()));
  } catch (...) {
    thrown_ = std::current_exception();
  }
  if (thrown_) XML_StopParser(parser_, XML_FALSE);
}

XmlStream::XmlStream(XmlListener& listener, std::string name) : listener_(listener), name_(std::move(name)) {
  const XML_Memory_Handling_Suite memory{&ParserMemory::take, &ParserMemory::retake, &ParserMemory::give_back};
  parser_ = XML_ParserCreate_MM(nullptr, &memory, nullptr);
  if (!parser_) throw std::bad_alloc();
  XML_SetUserData(parser_, this);
  XML_SetElementHandler(
      parser_,
      [](void* self, const char* element, const char** attributes) {
        auto& stream = *static_cast<XmlStream*>(self);
        stream.guarded([&] { stream.listener_.begin(element, attributes); });
      },
      [](void* self, const char*) {
        auto& stream = *static_cast<XmlStream*>(self);
        stream.guarded([&] { stream.listener_.end(); });
      });
  XML_SetStartDoctypeDeclHandler(parser_, [](void* self, const char*, const char*, const char*, int) {
    static_cast<XmlStream*>(self)->guarded(
        [] { throw Error(ErrorCode::kUnsupported, "a document type, which is not read here"); });
  });
}

XmlStream::~XmlStream() { XML_ParserFree(parser_); }

void XmlStream::parse(std::string_view piece, bool last) {
  if (!begun_) XML_SetEncoding(parser_, encoding_of(piece));
  begun_ = true;
  const bool read = XML_Parse(parser_, piece.data(), static_cast<int>(piece.size()), last) == XML_STATUS_OK;
  if (thrown_) std::rethrow_exception(thrown_);
  if (!read) fail();
}

void XmlStream::fail() const {
  const XML_Error error = XML_GetErrorCode(parser_);
  if (error == XML_ERROR_NO_MEMORY)
    throw Error(ErrorCode::kLimit, "its elements are too long, too deep or have too many names", place());
  throw Error(ErrorCode::kSyntax, fmt::format("this is not XML: {}", XML_ErrorString(error)), place());
}

std::string XmlStream::place() const {
  return fmt::format("{}:{}:{}", name_, XML_GetCurrentLineNumber(parser_), XML_GetCurrentColumnNumber(parser_) + 1);
}

}  // namespace findspace::io
