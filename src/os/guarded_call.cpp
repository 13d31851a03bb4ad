// exit() cannot be undone: a handler of atexit sees that a guarded call is under way, writes the cause and leaves with
// _Exit. The C library calls each registration once, and each thread that hangs in exit() uses one up; hence the many.
// `present` is per thread and null outside a call: a normal end of the program passes through the handler silently.

#include "os/guarded_call.hpp"

#include "os/faults.hpp"

#include <array>
#include <atomic>
#include <cfenv>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <thread>

namespace terp {

struct OneAtATime::Lock {
  std::mutex mutex;
};

OneAtATime::OneAtATime() : lock_(std::make_unique<Lock>()) {}
OneAtATime::~OneAtATime() = default;

void OneAtATime::operator()(const std::function<void()>& call) const
{
  const std::lock_guard<std::mutex> hold(lock_->mutex);
  call();
}

namespace {

constexpr int stopped_itself = 3;  // exit status of a run that stops itself

struct Call {
  void* argument = nullptr;
  DescribeExit describe_exit = nullptr;
};
thread_local Call* present = nullptr;

/// Of threads that come here at once the first has the word, and the others wait for the end.
void end_program(const char* why)
{
  static std::atomic_flag has_the_word;
  while (has_the_word.test_and_set()) std::this_thread::sleep_for(std::chrono::seconds(1));
  std::array<char, 4096> text{};
  present->describe_exit(present->argument, why, text.data(), text.size());
  std::fputs("error: ", stderr);
  std::fputs(text.data(), stderr);
  std::fputs("\n", stderr);
  std::_Exit(stopped_itself);
}

/// exit() in the guarded code, as STOP of Fortran calls it.
void end_at_exit()
{
  if (present == nullptr) return;
  std::fflush(nullptr);
  end_program("ended the program (STOP, XIT or exit)");
}

/// exit() calls a function once for each time that it was registered: each thread that is in a law needs one.
bool register_end()
{
  constexpr int most_threads = 1024;
  for (int k = 0; k < most_threads; ++k) std::atexit(end_at_exit);
  return true;
}

}  // namespace

std::string call_guarded(void (*f)(void*), DescribeExit describe_exit, void* argument)
{
  static const bool registered = register_end();
  static_cast<void>(registered);
  Call call{argument, describe_exit};
  std::fenv_t environment;
  std::fegetenv(&environment);
  present = &call;
  std::string fault;
  try {
    fault = call_with_faults(f, argument, end_program);
  } catch (const std::exception& error) {
    fault = std::string("threw an exception: ") + error.what();
  } catch (...) {
    fault = "threw an exception";
  }
  present = nullptr;
  std::fesetenv(&environment);
  return fault;
}

}  // namespace terp
