// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The page and its requests over HTTP, on the loopback address only. Every request must carry the token of the link and
// the server's own host; one with a foreign origin is refused. It ends when the last page is closed. Keywords: local
// web server, cross-site request forgery, DNS rebinding, content security policy.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace findspace::app {

/// The page as one HTML text, and the script that draws space, made of web/ by tools/build_page.
struct PageFiles {
  std::string page, space;
};
/// Those that are built into the program.
PageFiles built_in_page();

class PageServer {
 public:
  /// Binds; throws Error where the port cannot be had. 0: any port. `kind`: what the page shows, "scene" or "packing".
  /// `answer`: of a request's text.
  PageServer(int port, PageFiles files, std::string_view kind, std::function<std::string(const std::string&)> answer);
  ~PageServer();
  PageServer(const PageServer&) = delete;
  PageServer& operator=(const PageServer&) = delete;

  /// "http://127.0.0.1:PORT/?token=..."
  std::string link() const;
  /// Answers until the last page is closed.
  void run();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace findspace::app
