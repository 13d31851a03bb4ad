// A task is done by a copy of this process, made by fork, so it knows what this process knew. The memory is one without
// a name, which copies share.
#include "os/children.hpp"

#include "math/errors.hpp"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace terp {

struct Children::Processes {
  std::size_t n_bytes = 0;
  void* memory = nullptr;
  std::map<pid_t, std::size_t> running = {};
};

Children::Children(std::size_t n_bytes) : state_(std::make_unique<Processes>())
{
  state_->n_bytes = n_bytes;
  state_->memory = ::mmap(nullptr, n_bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (state_->memory == MAP_FAILED)
    throw FileError(std::string("no memory for processes of sections: ") + std::strerror(errno));
}

Children::~Children() { ::munmap(state_->memory, state_->n_bytes); }

void* Children::shared() { return state_->memory; }

void Children::begin(std::size_t number, const std::string& what, const std::function<int()>& task)
{
  std::fflush(nullptr);  // what is not written yet must not be written twice
  const pid_t parent = ::getpid(), child = ::fork();
  if (child == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);  // a run then writes a checkpoint and ends
    std::exit(::getppid() == parent ? task() : 1);
  }
  if (child < 0) throw FileError("no process for " + what + ": " + std::strerror(errno));
  state_->running[child] = number;
}

std::optional<ChildEnd> Children::next_end()
{
  int status = 0;
  const pid_t child = ::waitpid(-1, &status, WNOHANG);
  const auto found = state_->running.find(child);
  if (child <= 0 || found == state_->running.end()) return std::nullopt;
  ChildEnd end{.number = found->second, .status = WIFEXITED(status) ? WEXITSTATUS(status) : 0};
  if (WIFSIGNALED(status))
    end.killed_by = "signal " + std::to_string(WTERMSIG(status)) + " (" + ::strsignal(WTERMSIG(status)) + ")";
  state_->running.erase(found);
  return end;
}

void Children::ask_to_stop()
{
  for (const auto& [child, number] : state_->running) ::kill(child, SIGTERM);
}

std::optional<OwnTask> own_task() { return std::nullopt; }

}  // namespace terp
