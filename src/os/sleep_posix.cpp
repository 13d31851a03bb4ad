#include "os/sleep.hpp"

#include <cstdint>

namespace terp {

template <class T>
void sleep_while(const std::atomic<T>& number, T value)
{
  number.wait(value);
}

template <class T>
void wake_one(std::atomic<T>& number)
{
  number.notify_one();
}

template <class T>
void wake_all(std::atomic<T>& number)
{
  number.notify_all();
}

#define TERP_SLEEP_ON(T)                                      \
  template void sleep_while(const std::atomic<T>& number, T); \
  template void wake_one(std::atomic<T>& number);             \
  template void wake_all(std::atomic<T>& number);
TERP_SLEEP_ON(std::int32_t)
TERP_SLEEP_ON(std::uint32_t)
#undef TERP_SLEEP_ON

}  // namespace terp
