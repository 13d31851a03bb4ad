// The memory is a file without a name. A process that we start has it open under the same number, which the environment
// tells with its own number: TERP_TASK=NUMBER:DESCRIPTOR:BYTES.
#include "os/children.hpp"

#include "math/errors.hpp"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <iterator>
#include <map>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

extern char** environ;

namespace terp {
namespace {

constexpr const char* variable = "TERP_TASK";

[[noreturn]] void refuse(const std::string& what)
{
  throw FileError("no memory for processes of sections: " + what + ": " + std::strerror(errno));
}

void* map_shared(int descriptor, std::size_t n_bytes)
{
  void* const memory = ::mmap(nullptr, n_bytes, PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, 0);
  if (memory == MAP_FAILED) refuse("mmap");
  return memory;
}

/// The words of our command line, each closed by a zero.
std::string own_command_line()
{
  std::ifstream file("/proc/self/cmdline", std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<std::string> environment_with(const std::string& task)
{
  std::vector<std::string> all{task};
  const std::string name = std::string(variable) + "=";
  for (char** entry = environ; *entry != nullptr; ++entry)
    if (!std::string(*entry).starts_with(name)) all.push_back(*entry);
  return all;
}

std::vector<char*> pointers(std::vector<std::string>& words)
{
  std::vector<char*> list;
  for (std::string& word : words) list.push_back(word.data());
  list.push_back(nullptr);
  return list;
}

/// What the child does between fork and its own program: nothing here may ask for memory.
[[noreturn]] void become_ourselves(char* const* arguments, char* const* environment, int memory, pid_t parent)
{
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);  // a run then writes a checkpoint and ends
  if (::getppid() == parent && ::fcntl(memory, F_SETFD, 0) == 0) ::execve("/proc/self/exe", arguments, environment);
  ::_exit(127);
}

}  // namespace

struct Children::Processes {
  int descriptor = -1;
  std::size_t n_bytes = 0;
  void* memory = nullptr;
  std::map<pid_t, std::size_t> running = {};
};

Children::Children(std::size_t n_bytes) : state_(std::make_unique<Processes>())
{
  state_->n_bytes = n_bytes;
  state_->descriptor = ::memfd_create("terp", MFD_CLOEXEC);
  if (state_->descriptor < 0) refuse("memfd_create");
  if (::ftruncate(state_->descriptor, static_cast<off_t>(n_bytes)) != 0) refuse("ftruncate");
  state_->memory = map_shared(state_->descriptor, n_bytes);
}

Children::~Children()
{
  ::munmap(state_->memory, state_->n_bytes);
  ::close(state_->descriptor);
}

void* Children::shared() { return state_->memory; }

void Children::begin(std::size_t number, const std::string& what)
{
  std::vector<std::string> words;
  const std::string line = own_command_line();
  for (std::size_t begin = 0; begin < line.size(); begin += words.back().size() + 1)
    words.emplace_back(line.c_str() + begin);
  auto variables = environment_with(std::string(variable) + "=" + std::to_string(number) + ":" +
                                    std::to_string(state_->descriptor) + ":" + std::to_string(state_->n_bytes));
  const auto arguments = pointers(words), environment = pointers(variables);
  const pid_t parent = ::getpid();
  std::fflush(nullptr);
  const pid_t child = ::fork();
  if (child == 0) become_ourselves(arguments.data(), environment.data(), state_->descriptor, parent);
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

std::optional<OwnTask> own_task()
{
  const char* const text = std::getenv(variable);
  if (text == nullptr) return std::nullopt;
  unsigned long number = 0, n_bytes = 0;
  int descriptor = -1;
  if (std::sscanf(text, "%lu:%d:%lu", &number, &descriptor, &n_bytes) != 3) return std::nullopt;
  ::unsetenv(variable);  // a run of a section starts no sections
  ::fcntl(descriptor, F_SETFD, FD_CLOEXEC);
  return OwnTask{number, map_shared(descriptor, n_bytes)};
}

}  // namespace terp
