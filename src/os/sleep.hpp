// A thread that sleeps until a number changes.
#pragma once

#include <atomic>

namespace terp {

/// Returns when another thread has set the number to something else and woken us. T: std::int32_t or std::uint32_t.
template <class T>
void sleep_while(const std::atomic<T>& number, T value);

/// One, or all, of those who sleep on the number.
template <class T>
void wake_one(std::atomic<T>& number);
template <class T>
void wake_all(std::atomic<T>& number);

}  // namespace terp
