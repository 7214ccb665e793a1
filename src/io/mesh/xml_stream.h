// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// XML that comes in pieces and is not kept, by expat. Guarantee: memory does not grow with the text. Elements nested
// too deeply or too long, and too many names, are Error(kLimit); a document type is refused, so there are no entities
// but the five of XML. Errors: Error(kSyntax) with the line and column. For a tree: pugixml. Keywords: SAX, push
// parser.
#pragma once

#include <exception>
#include <string>
#include <string_view>

struct XML_ParserStruct;

namespace findspace::io {

/// Names and values in turn, then null.
using XmlAttributes = const char* const*;

/// Null where there is none of that name.
const char* xml_attribute(XmlAttributes attributes, const char* name);

/// What the elements of a text are told to.
class XmlListener {
 public:
  virtual ~XmlListener() = default;
  virtual void begin(const char* name, XmlAttributes attributes) = 0;
  virtual void end() = 0;
};

class XmlStream {
 public:
  /// `name`: of the text, in places. Errors of the listener are placed in it too.
  XmlStream(XmlListener& listener, std::string name);
  ~XmlStream();
  XmlStream(const XmlStream&) = delete;
  XmlStream& operator=(const XmlStream&) = delete;

  void take(std::string_view piece) { parse(piece, false); }
  /// There are no more pieces.
  void finish() { parse({}, true); }

 private:
  void parse(std::string_view piece, bool last);
  /// What is thrown within expat waits until it has returned.
  template <class Told>
  void guarded(Told told);
  [[noreturn]] void fail() const;
  std::string place() const;

  XmlListener& listener_;
  std::string name_;
  XML_ParserStruct* parser_;
  bool begun_ = false;
  std::exception_ptr thrown_;
};

}  // namespace findspace::io
