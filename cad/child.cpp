// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "child.h"

#include <signal.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <new>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace findspace::cad {
namespace {

using io::CadFace;
using io::CadFault;
using io::CadFile;
using io::CadMesh;
using io::CadPlace;
using io::CadProblem;
using io::CadRounded;

constexpr int kNoMemory = 1, kGaveUp = 2;  // how the child exits

/// One end of the socket. A value is its bytes, a list its length and its values.
class End {
 public:
  explicit End(int socket) : socket_(socket) {}

  bool send(const void* from, std::size_t size) const {
    const char* at = static_cast<const char*>(from);
    while (size > 0) {
      const ssize_t n = ::send(socket_, at, size, MSG_NOSIGNAL);
      if (n < 0 && errno == EINTR) continue;
      if (n <= 0) return false;
      at += n;
      size -= std::size_t(n);
    }
    return true;
  }
  bool receive(void* to, std::size_t size) const {
    char* at = static_cast<char*>(to);
    while (size > 0) {
      const ssize_t n = recv(socket_, at, size, 0);
      if (n < 0 && errno == EINTR) continue;
      if (n <= 0) return false;
      at += n;
      size -= std::size_t(n);
    }
    return true;
  }

  template <class T, std::enable_if_t<std::is_trivially_copyable_v<T>, int> = 0>
  bool put(const T& value) const {
    return send(&value, sizeof value);
  }
  template <class T, std::enable_if_t<std::is_trivially_copyable_v<T>, int> = 0>
  bool get(T& value) const {
    return receive(&value, sizeof value);
  }
  bool put(const std::string& text) const { return put(text.size()) && send(text.data(), text.size()); }
  bool get(std::string& text) const {
    std::size_t size = 0;
    if (!get(size)) return false;
    text.resize(size);
    return receive(text.data(), size);
  }
  template <class T>
  bool put(const std::vector<T>& list) const {
    if (!put(list.size())) return false;
    for (const T& value : list)
      if (!put(value)) return false;
    return true;
  }
  template <class T>
  bool get(std::vector<T>& list) const {
    std::size_t size = 0;
    if (!get(size)) return false;
    for (std::size_t k = 0; k < size; ++k)
      if (!get(list.emplace_back())) return false;
    return true;
  }
  bool put(const CadProblem& p) const { return put(p.fault) && put(p.message); }
  bool get(CadProblem& p) const { return get(p.fault) && get(p.message); }
  bool put(const CadFace& f) const {
    return put(f.corners) && put(f.face) && put(f.flat) && put(f.bound) && put(f.even);
  }
  bool get(CadFace& f) const { return get(f.corners) && get(f.face) && get(f.flat) && get(f.bound) && get(f.even); }
  bool put(const CadMesh& m) const { return put(m.places) && put(m.faces) && put(m.bound); }
  bool get(CadMesh& m) const { return get(m.places) && get(m.faces) && get(m.bound); }
  bool put(const CadRounded& r) const { return put(r.centers) && put(r.radius); }
  bool get(CadRounded& r) const { return get(r.centers) && get(r.radius); }

 private:
  int socket_;
};

struct Names {
  std::string part, place;
  std::vector<std::string> assemblies;
};

/// What is asked of the child: a mesh, or whether the solid is rounded.
struct Question {
  bool mesh = false;
  std::size_t solid = 0;
  double tolerance = 0;
  std::size_t most = 0;
};

bool answer(const End& end, const CadFile& file, const Question& asked) {
  if (!asked.mesh) {
    const auto rounded = file.rounded(asked.solid);
    return end.put(rounded.has_value()) && (!rounded || end.put(*rounded));
  }
  CadMesh mesh;
  const CadProblem problem = file.mesh(asked.solid, asked.tolerance, asked.most, mesh);
  return end.put(problem) && (problem.fault != CadFault::kNone || end.put(mesh));
}

void serve(const End& end, const ReadHere& read) {
  CadProblem problem;
  const std::unique_ptr<CadFile> file = read(problem);
  if (!end.put(problem) || !file) return;
  if (!end.put(file->notes()) || !end.put(file->solids())) return;
  for (std::size_t k = 0; k < file->solids(); ++k)
    if (!end.put(file->name(k)) || !end.put(file->place_name(k)) || !end.put(file->assemblies(k))) return;
  for (Question asked; end.get(asked) && answer(end, *file, asked);) {
  }
}

/// Dies with its parent, and by signals as programs do that do not handle them.
[[noreturn]] void be_child(int socket, pid_t parent, const ReadHere& read) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(0);
  std::set_new_handler(nullptr);
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGINT, SIGTERM, SIGHUP, SIGALRM})
    ::signal(signal, SIG_DFL);
  try {
    serve(End(socket), read);
  } catch (const std::bad_alloc&) {  // the parent sees the end of the socket
    _exit(kNoMemory);
  } catch (...) {
    _exit(kGaveUp);
  }
  _exit(0);
}

class ChildFile : public CadFile {
 public:
  ChildFile(int socket, pid_t child) : socket_(socket), child_(child), end_(socket) {}
  ChildFile(const ChildFile&) = delete;
  ChildFile& operator=(const ChildFile&) = delete;
  ~ChildFile() override {
    close(socket_);
    if (ended_) return;
    kill(child_, SIGKILL);
    wait_for(child_);
  }

  CadProblem open() {
    CadProblem problem;
    if (!end_.get(problem)) return died();
    if (problem.fault != CadFault::kNone) return problem;
    std::size_t count = 0;
    if (!end_.get(notes_) || !end_.get(count)) return died();
    for (std::size_t k = 0; k < count; ++k) {
      Names& names = names_.emplace_back();
      if (!end_.get(names.part) || !end_.get(names.place) || !end_.get(names.assemblies)) return died();
    }
    return {};
  }

  std::size_t solids() const override { return names_.size(); }
  std::string name(std::size_t k) const override { return names_[k].part; }
  std::string place_name(std::size_t k) const override { return names_[k].place; }
  std::vector<std::string> assemblies(std::size_t k) const override { return names_[k].assemblies; }
  std::vector<std::string> notes() const override { return notes_; }
  std::optional<CadRounded> rounded(std::size_t k) const override {
    CadRounded out;
    bool is = false;
    if (!end_.put(Question{false, k, 0, 0}) || !end_.get(is) || !is || !end_.get(out)) return std::nullopt;
    return out;
  }
  CadProblem mesh(std::size_t k, double tolerance, std::size_t most, CadMesh& out) const override {
    CadProblem problem;
    if (!end_.put(Question{true, k, tolerance, most}) || !end_.get(problem)) return died();
    if (problem.fault == CadFault::kNone && !end_.get(out)) return died();
    return problem;
  }

 private:
  static int wait_for(pid_t child) {
    int status = 0;
    while (waitpid(child, &status, 0) < 0)
      if (errno != EINTR) return 0;
    return status;
  }

  CadProblem died() const {
    if (!ended_) status_ = wait_for(child_);
    ended_ = true;
    if (WIFEXITED(status_) && WEXITSTATUS(status_) == kNoMemory) return {CadFault::kMemory, ""};
    if (!WIFSIGNALED(status_)) return {CadFault::kUnsupported, "Open CASCADE gave up on this file"};
    return {CadFault::kUnsupported, std::string("Open CASCADE crashed on this file (") + strsignal(WTERMSIG(status_)) +
                                        "): it is damaged, or holds what Open CASCADE cannot read"};
  }

  int socket_;
  pid_t child_;
  End end_;
  mutable bool ended_ = false;
  mutable int status_ = 0;
  std::vector<Names> names_;
  std::vector<std::string> notes_;
};

}  // namespace

std::unique_ptr<CadFile> read_in_child(const ReadHere& read, CadProblem& problem) {
  int sockets[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets) != 0) {
    problem = {CadFault::kFile, std::string("no socket to a process for Open CASCADE: ") + strerror(errno)};
    return nullptr;
  }
  const pid_t parent = getpid(), child = fork();
  if (child == 0) {
    close(sockets[0]);
    be_child(sockets[1], parent, read);
  }
  const int error = errno;
  close(sockets[1]);
  if (child < 0) {
    close(sockets[0]);
    problem = {CadFault::kFile, std::string("no process for Open CASCADE: ") + strerror(error)};
    return nullptr;
  }
  auto file = std::make_unique<ChildFile>(sockets[0], child);
  problem = file->open();
  if (problem.fault != CadFault::kNone) return nullptr;
  return file;
}

}  // namespace findspace::cad
