// A signal that comes from the guarded code jumps back to where it was called from. After that nothing of the guarded
// code may be trusted, but the memory of Terp is as safe as it was: the caller stops the run.

#include "os/faults.hpp"

#include <csetjmp>
#include <csignal>
#include <dlfcn.h>
#include <ucontext.h>
#include <unistd.h>
#include <vector>

namespace terp {
namespace {

constexpr int signals[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};
thread_local sigjmp_buf back;
thread_local volatile bool inside = false;
struct sigaction before[NSIG];

thread_local void (*end_of_program)(const char*) = nullptr;
const void* c_library = nullptr;  // where it is loaded

const char* describe_signal(int signal)
{
  switch (signal) {
    case SIGSEGV: return "used memory that is not its own (SIGSEGV)";
    case SIGBUS: return "used memory that is not there (SIGBUS)";
    case SIGFPE: return "divided a whole number by zero, or set traps for floating-point numbers (SIGFPE)";
    case SIGILL: return "has an instruction that this processor does not know (SIGILL)";
    default: return "called abort()";
  }
}

/// Whether the fault is in the C library, which may hold the lock of its memory then. A signal that the code sent
/// itself, as by raise(), is none.
bool is_in_c_library(const siginfo_t& info, void* context)
{
  if (info.si_code <= 0) return false;
  const auto& registers = static_cast<ucontext_t*>(context)->uc_mcontext.gregs;
  Dl_info at{};
  return dladdr(reinterpret_cast<void*>(registers[REG_RIP]), &at) != 0 && at.dli_fbase == c_library;
}

void jump_back(int signal, siginfo_t* info, void* context)
{
  if (inside) {
    if (signal == SIGABRT || is_in_c_library(*info, context)) end_of_program(describe_signal(signal));
    siglongjmp(back, signal);
  }
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
    if (Dl_info at{}; dladdr(dlsym(RTLD_DEFAULT, "malloc"), &at) != 0) c_library = at.dli_fbase;
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

}  // namespace

std::string call_with_faults(void (*f)(void*), void* argument, void (*end)(const char* why))
{
  static const Guard guard;
  thread_local const SignalStack stack;
  if (const int signal = sigsetjmp(back, 0); signal != 0) {
    inside = false;
    return describe_signal(signal);
  }
  end_of_program = end;
  inside = true;
  try {
    f(argument);
  } catch (...) {
    inside = false;
    throw;
  }
  inside = false;
  return {};
}

}  // namespace terp
