#include "meshing/process.hpp"

#include "base/errors.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>

extern char** environ;

namespace terp {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t most_output = 16384;
constexpr int longest_wait = 200;  // [ms] between looks at the clock

/// Both ends of a pipe, closed at the end of the scope; programs that we start do not inherit them.
struct Pipe {
  int ends[2] = {-1, -1};
  Pipe()
  {
    if (pipe2(ends, O_CLOEXEC) != 0) throw FileError(std::string("cannot make a pipe: ") + std::strerror(errno));
  }
  ~Pipe()
  {
    for (int k : {0, 1}) close_end(k);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  void close_end(int k)
  {
    if (ends[k] >= 0) close(ends[k]);
    ends[k] = -1;
  }
};

std::vector<char*> pointers(const std::vector<std::string>& words)
{
  std::vector<char*> list;
  for (const std::string& word : words) list.push_back(const_cast<char*>(word.c_str()));
  list.push_back(nullptr);
  return list;
}

std::vector<std::string> our_environment_and(const std::vector<std::string>& more)
{
  std::vector<std::string> all = more;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string own = *entry;
    const std::string name = own.substr(0, own.find('=') + 1);
    if (std::none_of(more.begin(), more.end(), [&](const std::string& word) { return word.starts_with(name); })) all.push_back(own);
  }
  return all;
}

/// 0, or the reason why it did not start.
int spawn(const std::vector<std::string>& arguments, const std::vector<std::string>& environment, int output, pid_t& pid)
{
  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;
  posix_spawn_file_actions_init(&actions);
  posix_spawnattr_init(&attributes);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, output, STDERR_FILENO);
  sigset_t interrupts, none;
  sigemptyset(&none);
  sigemptyset(&interrupts);
  for (const int signal : {SIGINT, SIGTERM, SIGPIPE}) sigaddset(&interrupts, signal);
  posix_spawnattr_setsigdefault(&attributes, &interrupts);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
  const int problem = posix_spawnp(&pid, arguments[0].c_str(), &actions, &attributes, pointers(arguments).data(), pointers(environment).data());
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  return problem;
}

/// Until the program closes its output. False: the time is over.
bool read_until(Clock::time_point end, int from, std::string& output)
{
  char buffer[4096];
  while (Clock::now() < end) {
    pollfd ready{from, POLLIN, 0};
    if (poll(&ready, 1, longest_wait) <= 0) continue;
    const ssize_t n = read(from, buffer, sizeof buffer);
    if (n == 0) return true;
    if (n > 0) output.append(buffer, static_cast<std::size_t>(n));
    if (output.size() > 2 * most_output) output.erase(0, output.size() - most_output);
  }
  return false;
}

int wait_for(pid_t pid)
{
  int status = 0;
  while (waitpid(pid, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

}  // namespace

ProcessResult run_process(const std::vector<std::string>& arguments, double seconds, const std::vector<std::string>& environment)
{
  Pipe pipe;
  ProcessResult result;
  pid_t pid = 0;
  const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  const int problem = spawn(arguments, our_environment_and(environment), pipe.ends[1], pid);
  if (problem == ENOENT || problem == EACCES || problem == ENOTDIR) return result;
  if (problem != 0) throw FileError("cannot start " + arguments[0] + ": " + std::strerror(problem));
  result.found = true;
  pipe.close_end(1);
  result.timed_out = !read_until(end, pipe.ends[0], result.output);
  if (result.timed_out) kill(pid, SIGKILL);
  const int status = wait_for(pid);
  if (WIFSIGNALED(status)) result.signal = WTERMSIG(status);
  if (WIFEXITED(status)) result.status = WEXITSTATUS(status);
  if (result.output.size() > most_output) result.output.erase(0, result.output.size() - most_output);
  return result;
}

}  // namespace terp
