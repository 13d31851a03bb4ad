// The child asks the kernel to be killed with us, so it is made by fork and not by posix_spawn. Between fork and its
// own program it may ask for no memory, as another thread may have held the lock of the heap. Why a program did not
// start comes back through a pipe, which a start closes.

#include "os/process.hpp"

#include "math/errors.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
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
    if (std::ranges::none_of(more, [&](const std::string& word) { return word.starts_with(name); })) all.push_back(own);
  }
  return all;
}

const int ending_signals[] = {SIGHUP, SIGINT, SIGTERM};

/// True if a signal that asks us to end is held back.
bool signal_waits()
{
  sigset_t waiting;
  sigpending(&waiting);
  return std::ranges::any_of(ending_signals, [&](int signal) { return sigismember(&waiting, signal) == 1; });
}

/// What the child does between fork and its own program: nothing here may ask for memory. Tells errno if it cannot
/// start.
[[noreturn]] void become(char* const* arguments, char* const* environment, int output, int trouble, pid_t parent)
{
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // nobody else would end it if we are killed
  const int nothing = open("/dev/null", O_RDONLY);
  if (getppid() == parent && nothing >= 0 && dup2(nothing, STDIN_FILENO) >= 0 && dup2(output, STDOUT_FILENO) >= 0 &&
      dup2(output, STDERR_FILENO) >= 0) {
    for (const int signal : {SIGHUP, SIGINT, SIGTERM, SIGPIPE}) std::signal(signal, SIG_DFL);
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
    execvpe(arguments[0], arguments, environment);
  }
  const int problem = errno;
  [[maybe_unused]] const auto told = write(trouble, &problem, sizeof problem);
  _exit(127);
}

/// 0, or the reason why it did not start. Not posix_spawn: that cannot ask for PR_SET_PDEATHSIG.
int spawn(
    const std::vector<std::string>& arguments, const std::vector<std::string>& environment, int output, pid_t& pid)
{
  Pipe trouble;  // closed by a successful start
  const auto words = pointers(arguments), variables = pointers(environment);
  const pid_t parent = getpid();
  pid = fork();
  if (pid < 0) return errno;
  if (pid == 0) become(words.data(), variables.data(), output, trouble.ends[1], parent);
  trouble.close_end(1);
  int problem = 0;
  ssize_t n = 0;
  while ((n = read(trouble.ends[0], &problem, sizeof problem)) < 0 && errno == EINTR) {
  }
  if (n != sizeof problem) return 0;
  waitpid(pid, nullptr, 0);
  return problem;
}

/// Until the program closes its output. False: the time is over, or we are asked to end.
bool read_until(double seconds, int from, const std::function<void(double)>& waiting, std::string& output)
{
  const auto start = Clock::now();
  const auto passed = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
  char buffer[4096];
  while (passed() < seconds && !signal_waits()) {
    if (waiting) waiting(passed());
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

ProcessResult run_process(const std::vector<std::string>& arguments, double seconds,
    const std::vector<std::string>& environment, const std::function<void(double)>& waiting)
{
  Pipe pipe;
  ProcessResult result;
  pid_t pid = 0;
  const int problem = spawn(arguments, our_environment_and(environment), pipe.ends[1], pid);
  if (problem == ENOENT || problem == EACCES || problem == ENOTDIR) return result;
  if (problem != 0) throw FileError("cannot start " + arguments[0] + ": " + std::strerror(problem));
  result.found = true;
  pipe.close_end(1);
  const bool ended = read_until(seconds, pipe.ends[0], waiting, result.output);
  if (!ended) kill(pid, SIGKILL);
  result.interrupted = signal_waits();
  result.timed_out = !ended && !result.interrupted;
  const int status = wait_for(pid);
  if (WIFSIGNALED(status)) result.signal = WTERMSIG(status);
  result.ended_by_keyboard = result.signal == SIGINT;
  if (WIFEXITED(status)) result.status = WEXITSTATUS(status);
  if (result.output.size() > most_output) result.output.erase(0, result.output.size() - most_output);
  return result;
}

std::string how_to_install(const std::string& package, const std::string&) { return "apt-get install " + package; }

struct SignalsHeld::Held {
  sigset_t set;
};

SignalsHeld::SignalsHeld() : before_(std::make_unique<Held>())
{
  sigset_t held;
  sigemptyset(&held);
  for (const int signal : ending_signals) {
    struct sigaction action {};
    if (sigaction(signal, nullptr, &action) == 0 && action.sa_handler != SIG_IGN) sigaddset(&held, signal);
  }
  pthread_sigmask(SIG_BLOCK, &held, &before_->set);
}

SignalsHeld::~SignalsHeld() { pthread_sigmask(SIG_SETMASK, &before_->set, nullptr); }

}  // namespace terp
