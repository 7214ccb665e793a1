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

namespace findspace::app {

class PageServer {
 public:
  /// Binds; throws Error where the port cannot be had. 0: any port. `answer`: of a request's text.
  PageServer(int port, std::string page, std::function<std::string(const std::string&)> answer);
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

/// The page as one HTML text, made of web/ by tools/build_page; empty where it was not built into the program.
std::string built_in_page();

}  // namespace findspace::app
