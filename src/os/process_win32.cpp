// The program is put into a job that ends what is in it when we end, however that is. It has our console, so that
// Ctrl-C reaches it as well.

#include "os/process.hpp"

#include "math/errors.hpp"
#include "os/stop.hpp"
#include "os/windows_start.hpp"
#include "os/windows_words.hpp"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <windows.h>

namespace terp {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t most_output = 16384;
constexpr DWORD wait_ms = 50;                  // between looks at the clock
constexpr DWORD ended_by_ctrl_c = 0xC000013A;  // STATUS_CONTROL_C_EXIT

/// Full path of NAME.exe in a folder of PATH, or of a path that is given; empty: there is none. The present folder is
/// not looked into: what lies beside a case is no program.
std::wstring find_program(const std::string& name)
{
  const auto with_ending = [](std::filesystem::path path) {
    return path.has_extension() ? path : path.replace_extension(".exe");
  };
  std::error_code ignored;
  if (name.find_first_of("/\\") != std::string::npos) {
    const auto path = with_ending(std::filesystem::path(name));
    return std::filesystem::is_regular_file(path, ignored) ? path.wstring() : L"";
  }
  const wchar_t* const all = _wgetenv(L"PATH");
  const std::wstring folders = all == nullptr ? L"" : all;
  for (std::size_t begin = 0; begin < folders.size();) {
    const std::size_t end = std::min(folders.find(L';', begin), folders.size());
    const std::filesystem::path folder(folders.substr(begin, end - begin));
    const auto path = with_ending(folder / name);
    if (folder.is_absolute() && std::filesystem::is_regular_file(path, ignored)) return path.wstring();
    begin = end + 1;
  }
  return L"";
}

struct Started {
  OwnedHandle output;
  StartedProgram program;
};

/// Throws FileError.
Started start(
    const std::wstring& program, const std::vector<std::string>& arguments, const std::vector<std::string>& environment)
{
  SECURITY_ATTRIBUTES inherited{.nLength = sizeof inherited, .lpSecurityDescriptor = nullptr, .bInheritHandle = TRUE};
  const OwnedHandle nothing(CreateFileW(L"NUL", GENERIC_READ, FILE_SHARE_READ, &inherited, OPEN_EXISTING, 0, nullptr));
  OwnedHandle output, writes;
  if (!CreatePipe(&output.handle, &writes.handle, &inherited, 0))
    throw FileError("cannot make a pipe: " + words_of_error(GetLastError()));
  std::wstring line = in_quotes(program);
  for (std::size_t k = 1; k < arguments.size(); ++k) line += L" " + in_quotes(wide(arguments[k]));
  StartedProgram started = start_program(arguments[0], program, line, environment_with(environment),
      {nothing.handle, writes.handle, writes.handle}, {nothing.handle, writes.handle}, true);
  return {std::move(output), std::move(started)};
}

void read_what_is_there(HANDLE from, std::string& output)
{
  char buffer[4096];
  DWORD waiting = 0, n = 0;
  while (PeekNamedPipe(from, nullptr, 0, nullptr, &waiting, nullptr) && waiting > 0 &&
         ReadFile(from, buffer, sizeof buffer, &n, nullptr) && n > 0) {
    output.append(buffer, n);
    if (output.size() > 2 * most_output) output.erase(0, output.size() - most_output);
  }
}

/// Until the program ends. False: the time is over, or we are asked to end.
bool read_until(double seconds, const Started& s, const std::function<void(double)>& waiting, std::string& output)
{
  const auto start = Clock::now();
  const auto passed = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
  while (passed() < seconds && !stop_requested) {
    if (waiting) waiting(passed());
    const bool ended = WaitForSingleObject(s.program.process.handle, wait_ms) == WAIT_OBJECT_0;
    read_what_is_there(s.output.handle, output);
    if (ended) return true;
  }
  return false;
}

}  // namespace

ProcessResult run_process(const std::vector<std::string>& arguments, double seconds,
    const std::vector<std::string>& environment, const std::function<void(double)>& waiting)
{
  ProcessResult result;
  const std::wstring program = find_program(arguments[0]);
  if (program.empty()) return result;
  const Started s = start(program, arguments, environment);
  result.found = true;
  const bool ended = read_until(seconds, s, waiting, result.output);
  if (!ended) TerminateJobObject(s.program.job.handle, 1);
  result.interrupted = stop_requested;
  result.timed_out = !ended && !result.interrupted;
  DWORD status = 0;
  WaitForSingleObject(s.program.process.handle, INFINITE);
  GetExitCodeProcess(s.program.process.handle, &status);
  result.ended_by_keyboard = status == ended_by_ctrl_c;
  result.status = static_cast<int>(status);
  if (result.output.size() > most_output) result.output.erase(0, result.output.size() - most_output);
  return result;
}

std::string how_to_install(const std::string&, const std::string& site)
{
  return "take the program from " + site + " and put its folder into PATH";
}

struct SignalsHeld::Held {
  bool listens = false;
};

/// A run that listens (stop.hpp) puts its things away by itself; before that, Ctrl-C must not end a scope of ours.
SignalsHeld::SignalsHeld() : before_(std::make_unique<Held>()) { listen_for_stop(); }

SignalsHeld::~SignalsHeld() = default;

}  // namespace terp
