// Time is counted in short waits, so that a program which the system stopped for a while is not taken for one that
// hangs: the stop is one wait.

#include "os/watch.hpp"

#include <algorithm>
#include <chrono>
#include <system_error>

namespace terp {
namespace {

constexpr double longest_wait_s = 0.1, waits_of_limit = 10.0;
constexpr double far_longer = 20.0;  // than the longest before

}  // namespace

Watch::Watch(double limit_s, std::function<void(double)> late) : limit_s_(limit_s), late_(std::move(late))
{
  try {
    thread_ = std::thread([this] { work(); });
  } catch (const std::system_error&) {
  }
}

Watch::~Watch()
{
  {
    const std::lock_guard lock(mutex_);
    leave_ = true;
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
}

void Watch::work()
{
  const double wait_s = std::min(longest_wait_s, limit_s_ / waits_of_limit);
  double waited_s = 0.0, longest_s = 0.0, next_s = limit_s_;
  unsigned last = heard_.load(std::memory_order_acquire);
  std::unique_lock lock(mutex_);
  while (!changed_.wait_for(lock, std::chrono::duration<double>(wait_s), [this] { return leave_; })) {
    waited_s += wait_s;
    if (const unsigned now = heard_.load(std::memory_order_acquire); now != last) {
      last = now;
      longest_s = std::max(longest_s, waited_s);
      waited_s = 0.0, next_s = std::max(limit_s_, far_longer * longest_s);
    } else if (waited_s >= next_s) {
      late_(waited_s);
      next_s *= 2.0;
    }
  }
}

}  // namespace terp
