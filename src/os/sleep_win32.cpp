// std::atomic::wait of g++ 12 sleeps on a table of condition variables here, and misses calls to wake up.

#include "os/sleep.hpp"

#include <cstdint>
#include <windows.h>

namespace terp {

template <class T>
void sleep_while(const std::atomic<T>& number, T value)
{
  auto* const place = const_cast<std::atomic<T>*>(&number);
  while (number.load() == value) WaitOnAddress(place, &value, sizeof value, INFINITE);
}

template <class T>
void wake_one(std::atomic<T>& number)
{
  WakeByAddressSingle(&number);
}

template <class T>
void wake_all(std::atomic<T>& number)
{
  WakeByAddressAll(&number);
}

#define TERP_SLEEP_ON(T)                                      \
  template void sleep_while(const std::atomic<T>& number, T); \
  template void wake_one(std::atomic<T>& number);             \
  template void wake_all(std::atomic<T>& number);
TERP_SLEEP_ON(std::int32_t)
TERP_SLEEP_ON(std::uint32_t)
#undef TERP_SLEEP_ON

}  // namespace terp
