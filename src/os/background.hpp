// Work for a thread of its own, done in the order in which it was given: what the run need not wait for.
// Not for: the step (threads.hpp).
#pragma once

#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace terp {

/// An error of a task is thrown by the next call of add or finish; what was given after that task is dropped.
class Background {
 public:
  /// most_waiting: tasks that may wait before `add` waits for the thread. Throws std::runtime_error if the system
  /// grants no thread.
  explicit Background(std::size_t most_waiting);
  ~Background();
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;

  void add(std::function<void()> task);
  /// Returns when all is done.
  void finish();

 private:
  void work();
  void throw_error();

  std::size_t most_waiting_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::function<void()>> tasks_;
  std::exception_ptr error_;
  bool busy_ = false, leave_ = false;
  std::thread thread_;  // last: it uses the rest
};

}  // namespace terp
