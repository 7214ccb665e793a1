// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "batch/job_workers.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <string_view>
#include <system_error>
#include <utility>

#include "batch/job_answer.h"
#include "findspace/error.h"

namespace findspace::app {
namespace {

constexpr std::size_t kBlock = std::size_t{1} << 16;
// A limit that the process itself does not keep, because it hangs where no signal is taken, is kept from outside.
constexpr double kGraceTimes = 1.5, kGraceSeconds = 2;

struct Pipe {
  std::array<int, 2> ends{-1, -1};
  Pipe() {
    if (pipe2(ends.data(), O_CLOEXEC) != 0)
      throw Error(ErrorCode::kLimit, fmt::format("no pipe to a worker: {}", std::system_category().message(errno)));
  }
};

bool write_all(int file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t n = write(file, text.data(), text.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    text.remove_prefix(static_cast<std::size_t>(n));
  }
  return true;
}

/// Appends what is there; false at the end.
bool read_some(int file, std::string& out) {
  std::array<char, kBlock> block{};
  ssize_t n = 0;
  do {
    n = ::read(file, block.data(), block.size());
  } while (n < 0 && errno == EINTR);
  if (n <= 0) return false;
  out.append(block.data(), static_cast<std::size_t>(n));
  return true;
}

void close_all(std::initializer_list<int> files) {
  for (const int file : files)
    if (file >= 0) close(file);
}

/// What a process said before it ended, without its name and without what it says of files.
std::string last_words(std::string said) {
  constexpr std::string_view kName = "findspace: ";
  while (!said.empty() && (said.back() == '\n' || said.back() == ' ')) said.pop_back();
  const std::size_t line = said.rfind('\n');
  if (line != said.npos) said.erase(0, line + 1);
  if (said.starts_with(kName)) said.erase(0, kName.size());
  return said.substr(0, said.find("; "));
}

}  // namespace

JobWorkers::JobWorkers(const JobList& jobs, const Options& batch, std::size_t count)
    : jobs_(jobs), batch_(batch), workers_(count) {
  for (Worker& w : workers_) start(w);
}

JobWorkers::~JobWorkers() {
  for (Worker& w : workers_) {
    if (w.process > 0) kill(w.process, SIGKILL);
    stop(w);
  }
}

/// What questions share is made once. Without a store, because the disk is full or the folder gone, each makes its own.
std::unique_ptr<StoreScope> JobWorkers::open_store() const {
  try {
    return std::make_unique<StoreScope>(ResultStore(batch_.store, batch_.store_limit));
  } catch (const Error&) {
    return nullptr;
  }
}

/// The loop of a worker: numbers of questions come in, lines of results go out.
void JobWorkers::serve(int questions, int answers, int errors) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  signal(SIGINT, SIG_IGN);  // of the terminal: the first process decides
  signal(SIGPIPE, SIG_DFL);
  dup2(errors, STDERR_FILENO);
  const auto store = open_store();
  for (std::size_t job = 0; ::read(questions, &job, sizeof job) == ssize_t(sizeof job);)
    if (!write_all(answers, answer_job(jobs_.job(job), job, batch_) + "\n")) break;
  _exit(0);
}

void JobWorkers::start(Worker& worker) {
  const Pipe questions, answers, errors;
  const pid_t parent = getpid();
  const pid_t process = fork();
  if (process < 0) {
    for (const Pipe* p : {&questions, &answers, &errors}) close_all({p->ends[0], p->ends[1]});
    throw Error(ErrorCode::kLimit, fmt::format("no process for a worker: {}", std::system_category().message(errno)));
  }
  if (process == 0) {
    for (const Worker& w : workers_) close_all({w.questions, w.answers, w.errors});
    close_all({questions.ends[1], answers.ends[0], errors.ends[0]});
    if (getppid() != parent) _exit(0);
    serve(questions.ends[0], answers.ends[1], errors.ends[1]);
  }
  close_all({questions.ends[0], answers.ends[1], errors.ends[1]});
  worker = {};
  worker.process = process;
  worker.questions = questions.ends[1];
  worker.answers = answers.ends[0];
  worker.errors = errors.ends[0];
}

void JobWorkers::stop(Worker& worker) {
  close_all({worker.questions, worker.answers, worker.errors});
  worker.questions = worker.answers = worker.errors = -1;
  if (worker.process > 0) waitpid(worker.process, nullptr, 0);
  worker.process = -1;
}

double JobWorkers::limit_of(const Job& job) const {
  constexpr std::string_view kOption = "--time-limit=";
  double seconds = batch_.time_limit;
  for (const std::string& argument : job.arguments)
    if (argument.starts_with(kOption)) seconds = std::strtod(argument.c_str() + kOption.size(), nullptr);
  return seconds > 0 ? seconds * kGraceTimes + kGraceSeconds : 0;
}

void JobWorkers::give(std::size_t job) {
  for (Worker& w : workers_) {
    if (w.job) continue;
    w.job = job;
    w.begun = Clock::now();
    w.limit = limit_of(jobs_.job(job));
    ++busy_;
    // Where this fails, the process has ended: `wait` sees its end.
    write_all(w.questions, {reinterpret_cast<const char*>(&job), sizeof job});
    return;
  }
}

/// The process has ended while it answered: the line that says so.
JobWorkers::Result JobWorkers::end_of(Worker& w) {
  int state = 0;
  waitpid(w.process, &state, 0);
  w.process = -1;
  JobEnd end{kInternal, last_words(w.said), std::chrono::duration<double>(Clock::now() - w.begun).count()};
  const bool late = w.limit > 0 && end.seconds > w.limit;
  if (WIFEXITED(state)) {
    end.status = ExitStatus(WEXITSTATUS(state));
  } else if (late) {
    end.status = kLimit;
    end.why = "the time limit is reached; the process did not react and was killed";
  } else if (WIFSIGNALED(state)) {
    end.why = fmt::format("the process was ended by signal {}, {}", WTERMSIG(state), sigdescr_np(WTERMSIG(state)));
  }
  if (end.why.empty()) end.why = fmt::format("the process ended with status {}", int(end.status));
  const bool killed = !late && WIFSIGNALED(state) && (WTERMSIG(state) == SIGKILL || WTERMSIG(state) == SIGTERM);
  return {*w.job, failure_line(jobs_.job(*w.job), *w.job, end), killed};
}

void JobWorkers::read(Worker& w, std::vector<Result>& out) {
  const bool more = read_some(w.answers, w.answer);
  if (more && w.answer.back() != '\n') return;
  if (more) {
    w.answer.pop_back();
    out.push_back({*w.job, std::exchange(w.answer, {})});
    w.said.clear();
    --busy_;
    w.job.reset();
    return;
  }
  while (read_some(w.errors, w.said)) {
  }
  if (w.job) {
    out.push_back(end_of(w));
    --busy_;
  }
  stop(w);
  start(w);
}

std::vector<JobWorkers::Result> JobWorkers::wait(std::chrono::milliseconds most) {
  std::vector<pollfd> files;
  for (const Worker& w : workers_) {
    files.push_back({w.answers, POLLIN, 0});
    files.push_back({w.errors, POLLIN, 0});
  }
  std::vector<Result> out;
  poll(files.data(), files.size(), static_cast<int>(most.count()));
  for (std::size_t k = 0; k < workers_.size(); ++k) {
    Worker& w = workers_[k];
    if ((files[2 * k + 1].revents & POLLIN) != 0) read_some(w.errors, w.said);
    if (files[2 * k].revents != 0) read(w, out);
    const bool late = w.job && w.limit > 0 && std::chrono::duration<double>(Clock::now() - w.begun).count() > w.limit;
    if (late) kill(w.process, SIGKILL);  // its end is read next time
  }
  return out;
}

}  // namespace findspace::app
