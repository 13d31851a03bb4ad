// A handler of exceptions of the system sends the thread back to where the guarded code was called from: it changes
// where the thread goes on, as jumping out of the handler itself would leave Windows in the middle of an exception.
// After that nothing of the guarded code may be trusted, but the memory of Terp is as safe as it was.

#include "os/faults.hpp"

#include <csignal>
#include <malloc.h>
#include <windows.h>

namespace terp {
namespace {

thread_local void* back[5];  // as __builtin_setjmp needs it
thread_local volatile bool inside = false;
thread_local volatile DWORD fault = 0;
constexpr DWORD called_abort = 1;  // no number of an exception

[[noreturn]] void jump_back() { __builtin_longjmp(back, 1); }

const char* words_of(DWORD code)
{
  switch (code) {
    case EXCEPTION_ACCESS_VIOLATION: return "used memory that is not its own (access violation)";
    case EXCEPTION_IN_PAGE_ERROR: return "used memory that is not there (in-page error)";
    case EXCEPTION_STACK_OVERFLOW: return "used up its stack";
    case EXCEPTION_INT_DIVIDE_BY_ZERO: return "divided a whole number by zero";
    case EXCEPTION_FLT_DIVIDE_BY_ZERO:
    case EXCEPTION_FLT_INVALID_OPERATION:
    case EXCEPTION_FLT_OVERFLOW:
    case EXCEPTION_FLT_UNDERFLOW:
    case EXCEPTION_FLT_INEXACT_RESULT: return "set traps for floating-point numbers";
    case EXCEPTION_ILLEGAL_INSTRUCTION:
    case EXCEPTION_PRIV_INSTRUCTION: return "has an instruction that this processor does not know";
    case called_abort: return "called abort()";
    default: return nullptr;  // as those of C++ and of debuggers
  }
}

LONG CALLBACK send_back(EXCEPTION_POINTERS* exception)
{
  const DWORD code = exception->ExceptionRecord->ExceptionCode;
  if (!inside || words_of(code) == nullptr) return EXCEPTION_CONTINUE_SEARCH;
  fault = code;
  CONTEXT& context = *exception->ContextRecord;
  context.Rip = reinterpret_cast<DWORD64>(&jump_back);
  context.Rsp = (context.Rsp & ~DWORD64{15}) - 8;  // as after a call
  return EXCEPTION_CONTINUE_EXECUTION;
}

void leave_abort(int)
{
  if (!inside) return;
  fault = called_abort;
  jump_back();
}

struct Guard {
  Guard()
  {
    AddVectoredExceptionHandler(1, send_back);
    std::signal(SIGABRT, leave_abort);
  }
};

/// Apart from its caller: what stands in registers there is not known after the jump.
[[gnu::noinline]] bool returns(void (*f)(void*), void* argument)
{
  if (__builtin_setjmp(back) != 0) return false;
  f(argument);
  return true;
}

}  // namespace

std::string call_with_faults(void (*f)(void*), void* argument, void (*)(const char*))
{
  static const Guard guard;
  inside = true;
  bool returned = false;
  try {
    returned = returns(f, argument);
  } catch (...) {
    inside = false;
    throw;
  }
  inside = false;
  if (returned) return {};
  if (fault == EXCEPTION_STACK_OVERFLOW) _resetstkoflw();
  std::signal(SIGABRT, leave_abort);  // Windows forgets it after one
  return words_of(fault);
}

}  // namespace terp
