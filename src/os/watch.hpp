// Looks whether other work goes on, from a thread of its own.
// Not for: ending that work, which cannot be done from outside.
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

namespace terp {

class Watch {
 public:
  /// late(seconds): called in the thread of the watch when nothing was heard for so long: limit_s, or 20 times what it
  /// took at most before. It is called again each time that this has doubled. Where the system grants no thread,
  /// nobody watches.
  Watch(double limit_s, std::function<void(double)> late);
  ~Watch();
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  /// The work goes on.
  void hear() { heard_.fetch_add(1, std::memory_order_release); }

 private:
  void work();

  double limit_s_;
  std::function<void(double)> late_;
  std::atomic<unsigned> heard_ = 0;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool leave_ = false;
  std::thread thread_;  // last: it uses the rest
};

}  // namespace terp
