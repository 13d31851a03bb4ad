// Two audiences, two words: InputError for the user's files, TERP_ASSERT for our own bugs.
// RunError is for what goes wrong while solving, FileError for disks and folders.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace terp {

/// One fault in a case file. The reader turns `key` into file:line:column and shows the line.
struct Problem {
  std::string
      key;  ///< dotted path of the key or table it is about, e.g. "material.clay.eta", "body[0].box"; may be empty
  std::string what;     ///< one short clause, lower case, no full stop: "softening is too steep"
  std::string detail;   ///< got and allowed, with units, and what to do; may have several lines; may be empty
  std::string topic;    ///< what `terp explain` says more about; may be empty
  bool at_key = false;  ///< true: point at the key itself; false: point at its value
  std::vector<std::string> others =
      {};  ///< keys and tables that contradict `key`; if --set changed one of them, the message points at that
};

/// The user's input is wrong: exit status 2. Contains every problem found.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::vector<Problem> problems)
      : std::runtime_error(problems.empty() ? "bad input" : text_of(problems.front())), problems_(std::move(problems))
  {
  }
  explicit InputError(Problem problem) : InputError(std::vector<Problem>{std::move(problem)}) {}
  const std::vector<Problem>& problems() const { return problems_; }

 private:
  static std::string text_of(const Problem& p)
  {
    return p.key + ": " + p.what + (p.detail.empty() ? "" : "\n  " + p.detail);
  }
  std::vector<Problem> problems_;
};

/// The run stopped itself (non-finite values, points put back at walls, no equilibrium): exit status 3.
class RunError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file or folder could not be read or written: exit status 1.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

[[noreturn]] void fail_assert(const char* condition, const char* file, int line);

}  // namespace terp

/// Checks what must be true if our own code is right. Active in the audit and sanitize builds and in Debug.
#ifdef TERP_AUDIT
#define TERP_ASSERT(condition) ((condition) ? void(0) : ::terp::fail_assert(#condition, __FILE__, __LINE__))
#else
#define TERP_ASSERT(condition) ((void)0)
#endif
