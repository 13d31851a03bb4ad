// Windows calls the handler on a thread of its own. When a console is closed, a user logs off or the machine goes down,
// the program is ended as soon as the handler returns: it waits, and Windows waits some seconds for it.

#include "os/stop.hpp"

#include <chrono>
#include <windows.h>

namespace terp {

std::atomic<bool> stop_requested{false};

namespace {

using Clock = std::chrono::steady_clock;
constexpr Clock::rep none = 0;
std::atomic<Clock::rep> first_request{none};
constexpr Clock::duration same_press = std::chrono::seconds(1);  // a key that is held down

BOOL WINAPI request_stop(DWORD event)
{
  const Clock::rep now = Clock::now().time_since_epoch().count();
  Clock::rep first = none;
  stop_requested.store(true);
  const bool is_first = first_request.compare_exchange_strong(first, now);
  if (event != CTRL_C_EVENT && event != CTRL_BREAK_EVENT) {
    Sleep(INFINITE);  // main ends the program
    return TRUE;
  }
  return is_first || Clock::duration(now - first) < same_press ? TRUE : FALSE;  // FALSE: the program ends at once
}

}  // namespace

void listen_for_stop()
{
  static std::atomic<bool> listens{false};
  if (!listens.exchange(true)) SetConsoleCtrlHandler(request_stop, TRUE);
}

}  // namespace terp
