// A signal that comes from the guarded code jumps back to where it was called from. After that nothing of the guarded
// code may be trusted, but the memory of Terp is as safe as it was: the caller stops the run.

#include "parallel/guarded_call.hpp"

#include <cfenv>
#include <csetjmp>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <unistd.h>
#include <vector>

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
  _exit(stopped_itself);
}

#ifdef _WIN32

struct Guard {
  Guard() { std::atexit(end_program); }
};

int call_with_signals(void (*f)(void*), void* argument)
{
  f(argument);
  return 0;
}

std::string describe_signal(int) { return ""; }

#else

constexpr int signals[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};
thread_local sigjmp_buf back;
struct sigaction before[NSIG];

void jump_back(int signal, siginfo_t* info, void* context)
{
  if (present != nullptr) siglongjmp(back, signal);
  const struct sigaction& other = before[signal];
  if ((other.sa_flags & SA_SIGINFO) != 0 && other.sa_sigaction != nullptr)
    return other.sa_sigaction(signal, info, context);
  if (other.sa_handler != SIG_DFL && other.sa_handler != SIG_IGN) return other.sa_handler(signal);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

struct Guard {
  Guard()
  {
    std::atexit(end_program);
    struct sigaction ours {};
    ours.sa_sigaction = jump_back;
    ours.sa_flags = SA_SIGINFO | SA_ONSTACK | SA_NODEFER;
    sigemptyset(&ours.sa_mask);
    for (const int signal : signals) sigaction(signal, &ours, &before[signal]);
  }
};

/// Room for the handler where the stack itself is what ran out.
struct SignalStack {
  static constexpr std::size_t size = 65536;
  SignalStack() : memory(size)
  {
    stack_t stack{};
    stack.ss_sp = memory.data();
    stack.ss_size = size;
    sigaltstack(&stack, &old);
  }
  ~SignalStack() { sigaltstack(&old, nullptr); }
  std::vector<char> memory;
  stack_t old{};
};

int call_with_signals(void (*f)(void*), void* argument)
{
  thread_local const SignalStack stack;
  if (const int signal = sigsetjmp(back, 0); signal != 0) return signal;
  f(argument);
  return 0;
}

std::string describe_signal(int signal)
{
  switch (signal) {
    case SIGSEGV: return "used memory that is not its own (SIGSEGV)";
    case SIGBUS: return "used memory that is not there (SIGBUS)";
    case SIGFPE: return "divided a whole number by zero, or set traps for floating-point numbers (SIGFPE)";
    case SIGILL: return "has an instruction that this processor does not know (SIGILL)";
    default: return "called abort()";
  }
}

#endif

}  // namespace

std::string call_guarded(void (*f)(void*), std::string (*describe_exit)(void*), void* argument)
{
  static const Guard guard;
  Call call{argument, describe_exit};
  std::fenv_t environment;
  std::fegetenv(&environment);
  present = &call;
  std::string fault;
  try {
    if (const int signal = call_with_signals(f, argument); signal != 0) fault = describe_signal(signal);
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
