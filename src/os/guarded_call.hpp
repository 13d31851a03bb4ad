// Calls of code that Terp did not compile and cannot trust: a fault in it comes back as words.
// Not for: how that code is found (shared_library.hpp).
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>

namespace terp {

/// Calls of several threads, one after the other.
class OneAtATime {
 public:
  OneAtATime();
  ~OneAtATime();
  void operator()(const std::function<void()>& call) const;

 private:
  struct Lock;
  std::unique_ptr<Lock> lock_;
};

/// Calls f(argument). Returns "" or why it did not return by itself: a signal as an access to memory that is not there
/// (not on Windows), or an exception. Objects of f and of what it calls are then not destroyed: f should have none. The
/// floating-point environment is put back afterwards. Some calls end the program, with status 3 and the text that
/// describe_exit(argument, why, text) writes: one of exit() in f and, but on Windows, abort() and a fault inside the C
/// library, whose memory nobody can ask for afterwards. So describe_exit must not ask for memory, and f may be inside
/// it: text has room for n letters, the last of which is '\0'.
using DescribeExit = void (*)(void* argument, const char* why, char* text, std::size_t n);
std::string call_guarded(void (*f)(void*), DescribeExit describe_exit, void* argument);

}  // namespace terp
