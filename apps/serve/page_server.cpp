// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "serve/page_server.h"

#include <fmt/format.h>
#include <httplib.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <mutex>
#include <random>
#include <thread>

#include "findspace/error.h"

namespace findspace::app {
namespace {

using namespace std::chrono_literals;

constexpr const char* kHost = "127.0.0.1";
constexpr std::size_t kMostBytes = std::size_t{64} << 20, kMostPages = 48, kThreads = 64,
                      kMostRequests = 1 << 30;  // of a connection
constexpr int kKeepAliveSeconds = 2;            // the end waits for idle connections
constexpr auto kPulse = 500ms;                  // between two signs of life on a page's connection
constexpr auto kReload = 2500ms;                // a page that is reloaded is gone for less than this

/// 128 random bits.
std::string random_text() {
  std::random_device source;
  std::string out;
  for (int k = 0; k < 4; ++k) out += fmt::format("{:08x}", source());
  return out;
}

void replace_all(std::string& text, std::string_view mark, std::string_view by) {
  for (std::size_t at = text.find(mark); at != text.npos; at = text.find(mark, at + by.size()))
    text.replace(at, mark.size(), by);
}

/// In a time that does not depend on where they differ.
bool same_token(const std::string& a, const std::string& b) {
  unsigned differ = a.size() != b.size();
  for (std::size_t k = 0; k < a.size() && k < b.size(); ++k) differ |= unsigned(a[k] ^ b[k]);
  return differ == 0;
}

/// As it is: the library packs what it is given whole, which takes a hundred times longer than sending it to this very
/// machine. What is given in pieces of a known length it sends.
void give(httplib::Response& response, std::string text, const char* type) {
  const auto kept = std::make_shared<const std::string>(std::move(text));
  response.set_content_provider(kept->size(), type,
                                [kept](std::size_t from, std::size_t length, httplib::DataSink& sink) {
                                  return sink.write(kept->data() + from, length);
                                });
}

}  // namespace

class PageServer::Impl {
 public:
  Impl(int port, PageFiles files, std::string_view kind, std::function<std::string(const std::string&)> answer)
      : files_(std::move(files)), answer_(std::move(answer)) {
    replace_all(files_.page, "__TOKEN__", token_);
    replace_all(files_.page, "__KIND__", kind);
    server_.set_payload_max_length(kMostBytes);
    server_.set_tcp_nodelay(true);
    server_.set_keep_alive_max_count(kMostRequests);
    server_.set_keep_alive_timeout(kKeepAliveSeconds);
    // The port is this process's alone.
    server_.set_socket_options([](auto) {});
    server_.new_task_queue = [] { return new httplib::ThreadPool(kThreads); };
    port_ = port == 0 ? server_.bind_to_any_port(kHost) : server_.bind_to_port(kHost, port) ? port : -1;
    if (port_ <= 0) throw Error(ErrorCode::kUsage, fmt::format("--port {}: it cannot be had", port));
    add_routes();
  }

  std::string link() const { return fmt::format("http://{}:{}/?token={}", kHost, port_, token_); }

  void run() {
    std::thread watch([this] { end_with_last_page(); });
    server_.listen_after_bind();
    ended_ = true;
    watch.join();
  }

 private:
  void add_routes() {
    server_.set_pre_routing_handler([this](const httplib::Request& request, httplib::Response& response) {
      response.set_header("X-Content-Type-Options", "nosniff");
      response.set_header("Referrer-Policy", "no-referrer");
      response.set_header("Cache-Control", "no-store");
      response.set_header("Cross-Origin-Resource-Policy", "same-origin");
      if (is_allowed(request)) return httplib::Server::HandlerResponse::Unhandled;
      response.status = 403;
      response.set_content("refused: this link is not complete, or not of this server\n", "text/plain");
      return httplib::Server::HandlerResponse::Handled;
    });
    server_.Get("/", [this](const httplib::Request&, httplib::Response& response) { give_page(response); });
    server_.Get("/space.js", [this](const httplib::Request&, httplib::Response& response) {
      give(response, std::string(files_.space), "text/javascript; charset=utf-8");
    });
    server_.Get("/open", [this](const httplib::Request&, httplib::Response& response) { keep_open(response); });
    server_.Post("/rpc", [this](const httplib::Request& request, httplib::Response& response) {
      std::lock_guard lock(guard_);
      give(response, answer_(request.body), "application/json");
    });
  }

  bool is_allowed(const httplib::Request& request) const {
    const std::string host = request.get_header_value("Host"), origin = request.get_header_value("Origin");
    const std::string here = fmt::format("{}:{}", kHost, port_), local = fmt::format("localhost:{}", port_);
    if (host != here && host != local) return false;
    if (!origin.empty() && origin != "http://" + host) return false;
    const std::string token = request.has_header("X-Findspace-Token") ? request.get_header_value("X-Findspace-Token")
                                                                      : request.get_param_value("token");
    return same_token(token, token_);
  }

  void give_page(httplib::Response& response) const {
    const std::string once = random_text();
    std::string page = files_.page;
    replace_all(page, "__NONCE__", once);
    response.set_header("Content-Security-Policy",
                        fmt::format("default-src 'none'; script-src 'nonce-{0}'; style-src 'nonce-{0}'; connect-src "
                                    "'self'; img-src data: blob:; base-uri 'none'; form-action 'none'; "
                                    "frame-ancestors 'none'",
                                    once));
    give(response, std::move(page), "text/html; charset=utf-8");
  }

  /// A connection that stays as long as the page does.
  void keep_open(httplib::Response& response) {
    if (pages_ >= int(kMostPages)) {
      response.status = 503;
      return;
    }
    ++pages_;
    seen_ = true;
    response.set_chunked_content_provider(
        "text/event-stream",
        [this](std::size_t, httplib::DataSink& sink) {
          constexpr std::string_view kSign = ": open\n\n";
          if (ended_ || !sink.write(kSign.data(), kSign.size())) return false;
          std::this_thread::sleep_for(kPulse);
          return true;
        },
        [this](bool) {
          --pages_;
          last_ = std::chrono::steady_clock::now().time_since_epoch().count();
        });
  }

  void end_with_last_page() {
    using Clock = std::chrono::steady_clock;
    while (!ended_) {
      std::this_thread::sleep_for(kPulse);
      const Clock::time_point last{Clock::duration(last_.load())};
      if (seen_ && pages_ == 0 && Clock::now() - last > kReload) break;
    }
    server_.stop();
  }

  httplib::Server server_;
  PageFiles files_;
  std::string token_ = random_text();
  std::function<std::string(const std::string&)> answer_;
  std::mutex guard_;
  int port_ = 0;
  std::atomic<int> pages_ = 0;
  std::atomic<bool> seen_ = false, ended_ = false;
  std::atomic<std::chrono::steady_clock::rep> last_ = 0;
};

PageServer::PageServer(int port, PageFiles files, std::string_view kind,
                       std::function<std::string(const std::string&)> answer)
    : impl_(std::make_unique<Impl>(port, std::move(files), kind, std::move(answer))) {}
PageServer::~PageServer() = default;
std::string PageServer::link() const { return impl_->link(); }
void PageServer::run() { impl_->run(); }

}  // namespace findspace::app
