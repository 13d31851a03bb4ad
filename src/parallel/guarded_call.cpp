#include "parallel/guarded_call.hpp"

#include "parallel/faults.hpp"

#include <cfenv>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <mutex>

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

/// The call that a thread is in.
struct Call {
  void* argument = nullptr;
  std::string (*describe_exit)(void*) = nullptr;
};
thread_local Call* present = nullptr;

/// exit() in the guarded code, as STOP of Fortran calls it.
void end_program()
{
  if (present == nullptr) return;
  const std::string text = present->describe_exit(present->argument);
  present = nullptr;
  std::fprintf(stderr, "error: %s\n", text.c_str());
  std::fflush(nullptr);
  std::_Exit(stopped_itself);
}

}  // namespace

std::string call_guarded(void (*f)(void*), std::string (*describe_exit)(void*), void* argument)
{
  static const int at_exit = std::atexit(end_program);
  static_cast<void>(at_exit);
  Call call{argument, describe_exit};
  std::fenv_t environment;
  std::fegetenv(&environment);
  present = &call;
  std::string fault;
  try {
    fault = call_with_faults(f, argument);
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
