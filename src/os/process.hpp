// Runs another program and waits for it: no shell, its output kept for a message.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace terp {

struct ProcessResult {
  bool found = false;              ///< false: no such program in PATH
  bool timed_out = false;          ///< it was ended after its time
  bool interrupted = false;        ///< it was ended because a signal waits for us (SignalsHeld)
  bool ended_by_keyboard = false;  ///< Ctrl-C ended it
  int signal = 0;                  ///< that ended it; 0: none did
  int status = 0;                  ///< its exit status
  std::string output;              ///< both its streams, in order, at most the last 16 kB

  bool succeeded() const { return found && !timed_out && signal == 0 && status == 0; }
};

/// arguments: the program, looked up in PATH, then its arguments. environment: "NAME=value" added to ours. waiting:
/// called a few times per second with the time that has passed [s].
/// The program ends with us: when Ctrl-C is pressed, for it stays in our process group and takes the signal's default,
/// and however else we end, for the kernel kills it when the thread that called is gone.
ProcessResult run_process(const std::vector<std::string>& arguments, double seconds,
    const std::vector<std::string>& environment = {}, const std::function<void(double)>& waiting = {});

/// What a user does to have a free program: this system has it as a package, or `site` has it. As "apt-get install
/// gmsh".
std::string how_to_install(const std::string& package, const std::string& site);

/// While it lives, signals that ask this thread to end wait, so that a scope can put its things away first; they arrive
/// at the end of it. run_process ends its program as soon as one waits. Signals that are ignored stay so.
class SignalsHeld {
 public:
  SignalsHeld();
  ~SignalsHeld();
  SignalsHeld(const SignalsHeld&) = delete;
  SignalsHeld& operator=(const SignalsHeld&) = delete;

 private:
  struct Held;
  std::unique_ptr<Held> before_;
};

}  // namespace terp
