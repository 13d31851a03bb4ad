// The copy says in memory that both see when the task is through: an exit status says nothing, as the task may exit. It
// leads a group of processes, which is killed as a whole before the copy is taken note of, so that its number stands.

#include "os/own_copy.hpp"

#include "math/errors.hpp"

#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fmt/format.h>
#include <new>
#include <pthread.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace terp {
namespace {

using Clock = std::chrono::steady_clock;

bool copied = false;
std::atomic<int> n_forks = 0;

[[noreturn]] void refuse(const char* what)
{
  throw FileError(fmt::format("no process for the trial of a library: {}: {}", what, std::strerror(errno)));
}

class SharedMemory {
 public:
  explicit SharedMemory(std::size_t n_bytes)
      : n_bytes_(n_bytes), at_(::mmap(nullptr, n_bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0))
  {
    if (at_ == MAP_FAILED) refuse("mmap");
  }
  ~SharedMemory() { ::munmap(at_, n_bytes_); }
  SharedMemory(const SharedMemory&) = delete;
  SharedMemory& operator=(const SharedMemory&) = delete;
  void* at(std::size_t byte) const { return static_cast<char*>(at_) + byte; }

 private:
  std::size_t n_bytes_;
  void* at_;
};

[[noreturn]] void be_copy(
    const std::function<void(void*)>& task, void* result, std::atomic<bool>& is_through, pid_t parent)
{
  copied = true;
  const int forks = n_forks;
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(1);
  const rlimit no_core{0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
  try {
    task(result);
  } catch (...) {
  }
  std::fflush(nullptr);
  if (n_forks == forks) is_through = true;
  ::_exit(0);
}

/// "" or why it was not waited for any longer.
std::string wait_for(pid_t copy, double limit_s)
{
  constexpr useconds_t between = 500;  // [us]
  const auto start = Clock::now();
  for (;;) {
    siginfo_t end{};
    if (::waitid(P_PID, static_cast<id_t>(copy), &end, WEXITED | WNOHANG | WNOWAIT) != 0 && errno != EINTR) return {};
    if (end.si_pid == copy) return {};
    if (std::chrono::duration<double>(Clock::now() - start).count() > limit_s)
      return fmt::format("did not come to an end within {:g} s: it may loop", limit_s);
    ::usleep(between);
  }
}

}  // namespace

std::string call_in_copy(
    const std::function<void(void* result)>& task, void* result, std::size_t n_bytes, double limit_s)
{
  fork_count();  // from here on forks are counted
  const SharedMemory memory(sizeof(std::atomic<bool>) + alignof(std::max_align_t) + n_bytes);
  auto& is_through = *new (memory.at(0)) std::atomic<bool>(false);
  void* const shared = memory.at(alignof(std::max_align_t));
  std::memcpy(shared, result, n_bytes);
  std::fflush(nullptr);  // what is not written yet must not be written twice
  const pid_t parent = ::getpid(), copy = ::fork();
  if (copy < 0) refuse("fork");
  if (copy == 0) be_copy(task, shared, is_through, parent);
  ::setpgid(copy, copy);
  std::string fault = wait_for(copy, limit_s);
  ::kill(-copy, SIGKILL);
  int status = 0;
  while (::waitpid(copy, &status, 0) < 0 && errno == EINTR) continue;
  if (!fault.empty()) return fault;
  if (WIFSIGNALED(status))
    return fmt::format("was ended by signal {} ({})", WTERMSIG(status), ::strsignal(WTERMSIG(status)));
  if (!is_through) return "ended before its time, as by STOP, XIT or exit";
  std::memcpy(result, shared, n_bytes);
  return {};
}

bool is_copy() { return copied; }

int fork_count()
{
  static const int registered = ::pthread_atfork(nullptr, nullptr, [] { ++n_forks; });
  static_cast<void>(registered);
  return n_forks;
}

}  // namespace terp
