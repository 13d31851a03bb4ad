// The program itself, run as a user runs it.
#pragma once

#include "support/paths.hpp"

#include <source_location>

#include <sys/types.h>

namespace terp::test {

/// How a program ended and what it said.
struct Finished {
  int status = -1;       ///< exit status; 128 + signal if it was killed by one
  std::string out, err;  ///< standard output and error
};

/// A running terp whose output goes to files.
class Process {
 public:
  explicit Process(const std::vector<std::string>& arguments, const std::string& working_folder = "");
  /// Kills the program if it still runs.
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  pid_t pid() const { return pid_; }
  void send(int signal) const;
  Finished wait();

 private:
  ScratchFolder output_;
  pid_t pid_ = -1;
};

/// Runs `terp` with these arguments to its end. working_folder: "" is the caller's.
Finished terp(const std::vector<std::string>& arguments, const std::string& working_folder = "");

/// Arguments with others behind them.
std::vector<std::string> with(std::vector<std::string> arguments, const std::vector<std::string>& more);

/// The program, which is to end well: the test fails where it did not.
Finished succeeded(const Finished& f, std::source_location where = std::source_location::current());

/// What the program says on standard error, which is to end with this status.
std::string error_with(int status, const Finished& f, std::source_location where = std::source_location::current());

/// The whole content of a file; "" if there is none.
std::string text_of(const std::string& path);
void write_text(const std::string& path, const std::string& text);
/// Names in a folder, sorted.
std::vector<std::string> names_in(const std::string& folder);

}  // namespace terp::test
