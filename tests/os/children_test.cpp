#include "os/children.hpp"

#include "os/stop.hpp"
#include "os/terminal.hpp"
#include "support/test.hpp"

#include <atomic>
#include <csignal>

namespace children_test {

TEST(Children, ShareMemoryAndSayHowTheyEnded)
{
  Children children(sizeof(std::atomic<int>));
  auto& begun = *static_cast<std::atomic<int>*>(children.shared());
  const auto wait_to_be_asked = [&] {
    listen_for_stop();
    ++begun;
    while (!stop_requested) wait_seconds(0.01);
    return 40;
  };
  children.begin(0, "a test", wait_to_be_asked);
  children.begin(1, "a test", [&] { return ++begun, std::raise(SIGKILL); });
  while (begun < 2) wait_seconds(0.01);
  children.ask_to_stop();
  std::map<std::size_t, ChildEnd> ends;
  while (ends.size() < 2)
    if (const auto end = children.next_end()) ends[end->number] = *end;
  EXPECT_EQ(ends.at(0).status, 40);
  EXPECT_EQ(ends.at(0).killed_by, "");
  EXPECT_EQ(ends.at(1).killed_by, "signal 9 (Killed)");
}

}  // namespace children_test
