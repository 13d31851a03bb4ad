// A process that we start inherits the shared memory, an event that asks it to stop, and a handle of ours to see when
// we end. The environment tells it their numbers: TERP_TASK=NUMBER:MEMORY:EVENT:PARENT.
#include "os/children.hpp"

#include "math/errors.hpp"
#include "os/files.hpp"
#include "os/stop.hpp"
#include "os/windows_start.hpp"
#include "os/windows_words.hpp"

#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <windows.h>

namespace terp {
namespace {

constexpr const char* variable = "TERP_TASK";

[[noreturn]] void refuse(const char* what)
{
  throw FileError(std::string("no memory for processes of sections: ") + what + ": " + words_of_error(GetLastError()));
}

void make_inheritable(HANDLE handle) { SetHandleInformation(handle, HANDLE_FLAG_INHERIT, HANDLE_FLAG_INHERIT); }

void* map_shared(HANDLE mapping)
{
  void* const memory = MapViewOfFile(mapping, FILE_MAP_ALL_ACCESS, 0, 0, 0);
  if (memory == nullptr) refuse("MapViewOfFile");
  return memory;
}

std::uintptr_t number_of(HANDLE handle) { return reinterpret_cast<std::uintptr_t>(handle); }

/// The event, or the end of who started us, is the wish to stop.
DWORD WINAPI watch(void* both)
{
  WaitForMultipleObjects(2, static_cast<const HANDLE*>(both), FALSE, INFINITE);
  stop_requested.store(true);
  return 0;
}

}  // namespace

struct Children::Processes {
  OwnedHandle mapping, stop, ourselves;
  void* memory = nullptr;
  std::map<std::size_t, OwnedHandle> running = {};
};

Children::Children(std::size_t n_bytes) : state_(std::make_unique<Processes>())
{
  state_->mapping.handle = CreateFileMappingW(INVALID_HANDLE_VALUE, nullptr, PAGE_READWRITE,
      static_cast<DWORD>(n_bytes >> 32), static_cast<DWORD>(n_bytes), nullptr);
  state_->stop.handle = CreateEventW(nullptr, TRUE, FALSE, nullptr);
  if (state_->mapping.handle == nullptr || state_->stop.handle == nullptr) refuse("CreateFileMapping");
  if (!DuplicateHandle(GetCurrentProcess(), GetCurrentProcess(), GetCurrentProcess(), &state_->ourselves.handle,
          SYNCHRONIZE, TRUE, 0))
    refuse("DuplicateHandle");
  make_inheritable(state_->mapping.handle);
  make_inheritable(state_->stop.handle);
  state_->memory = map_shared(state_->mapping.handle);
}

Children::~Children() { UnmapViewOfFile(state_->memory); }

void* Children::shared() { return state_->memory; }

void Children::begin(std::size_t number, const std::string& what, const std::function<int()>&)
{
  const HANDLE mapping = state_->mapping.handle, stop = state_->stop.handle, ourselves = state_->ourselves.handle;
  char task[200];
  std::snprintf(task, sizeof task, "%s=%llu:%" PRIuPTR ":%" PRIuPTR ":%" PRIuPTR, variable,
      static_cast<unsigned long long>(number), number_of(mapping), number_of(stop), number_of(ourselves));
  SECURITY_ATTRIBUTES inherited{.nLength = sizeof inherited, .lpSecurityDescriptor = nullptr, .bInheritHandle = TRUE};
  const OwnedHandle nothing(CreateFileW(
      L"NUL", GENERIC_READ | GENERIC_WRITE, FILE_SHARE_READ | FILE_SHARE_WRITE, &inherited, OPEN_EXISTING, 0, nullptr));
  std::fflush(nullptr);
  StartedProgram started =
      start_program("the process for " + what, wide(program_file()), GetCommandLineW(), environment_with({task}),
          {nothing.handle, nothing.handle, nothing.handle}, {nothing.handle, mapping, stop, ourselves}, false);
  state_->running.emplace(number, std::move(started.process));
}

std::optional<ChildEnd> Children::next_end()
{
  for (auto child = state_->running.begin(); child != state_->running.end(); ++child) {
    if (WaitForSingleObject(child->second.handle, 0) != WAIT_OBJECT_0) continue;
    DWORD status = 0;
    GetExitCodeProcess(child->second.handle, &status);
    ChildEnd end{.number = child->first, .status = static_cast<int>(status)};
    constexpr DWORD first_error = 0xC0000000;  // NTSTATUS: how the system ends a program
    if (status >= first_error) {
      char text[40];
      std::snprintf(text, sizeof text, "Windows (status 0x%08lX)", status);
      end.killed_by = text;
    }
    state_->running.erase(child);
    return end;
  }
  return std::nullopt;
}

void Children::ask_to_stop() { SetEvent(state_->stop.handle); }

std::optional<OwnTask> own_task()
{
  const char* const text = std::getenv(variable);
  unsigned long long number = 0;
  std::uintptr_t mapping = 0;
  static std::uintptr_t events[2] = {0, 0};
  static_assert(sizeof(HANDLE) == sizeof(std::uintptr_t));
  if (text == nullptr ||
      std::sscanf(text, "%llu:%" SCNuPTR ":%" SCNuPTR ":%" SCNuPTR, &number, &mapping, &events[0], &events[1]) != 4)
    return std::nullopt;
  _putenv("TERP_TASK=");  // a run of a section starts no sections
  CloseHandle(CreateThread(nullptr, 0, watch, events, 0, nullptr));
  return OwnTask{static_cast<std::size_t>(number), map_shared(reinterpret_cast<HANDLE>(mapping))};
}

}  // namespace terp
