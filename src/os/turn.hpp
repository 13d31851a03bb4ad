// One thread at a time, for what the system or a library does not lock.
#pragma once

#include <mutex>

namespace terp {

/// While an object of Turn<Of> lives, other threads wait to make one. A thread may make several.
template <class Of>
class Turn {
  static inline std::recursive_mutex one_at_a_time;
  std::lock_guard<std::recursive_mutex> lock{one_at_a_time};
};

/// Calls of several threads, one after the other.
class OneAtATime {
 public:
  template <class Call>
  void operator()(Call&& call) const
  {
    const std::lock_guard<std::mutex> hold(mutex_);
    call();
  }

 private:
  mutable std::mutex mutex_;
};

}  // namespace terp
