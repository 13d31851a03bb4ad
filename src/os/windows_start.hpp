// How Windows starts a program.
// Not for: files that Linux compiles; only NAME_win32.cpp includes this.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace terp {

/// A handle of Windows, closed at the end of the scope.
struct OwnedHandle {
  void* handle = nullptr;
  OwnedHandle() = default;
  explicit OwnedHandle(void* h) : handle(h) {}
  OwnedHandle(OwnedHandle&& other) noexcept : handle(std::exchange(other.handle, nullptr)) {}
  ~OwnedHandle();
  OwnedHandle(const OwnedHandle&) = delete;
  OwnedHandle& operator=(const OwnedHandle&) = delete;
  OwnedHandle& operator=(OwnedHandle&&) = delete;
};

struct StartedProgram {
  OwnedHandle process;
  OwnedHandle job;  ///< ends the program when it is closed, as it is when we end
};

/// A word as Windows takes a command line apart again.
std::wstring in_quotes(const std::wstring& word);

/// Our environment, with `more` in place of variables of the same name, each "NAME=value".
std::wstring environment_with(const std::vector<std::string>& more);

/// program: its path. line: the whole command line. streams: its standard input, output and error. inherited: handles
/// that it has too, those of its streams among them. dies_with_us: into a job. Throws FileError "cannot start <name>".
StartedProgram start_program(const std::string& name, const std::wstring& program, std::wstring line,
    std::wstring environment, void* const (&streams)[3], std::vector<void*> inherited, bool dies_with_us);

}  // namespace terp
