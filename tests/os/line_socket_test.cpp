#include "os/line_socket.hpp"
#include "support/test.hpp"

#include <csignal>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace line_socket_test {

using Got = LineSocket::Got;

LineSocket reach(const LineServer& server) { return connect_to("127.0.0.1", server.port(), 2000).value(); }

/// Waits for the next event, a second at most.
LineServer::Event next_of(LineServer& server)
{
  for (int k = 0; k < 20; ++k)
    if (const auto events = server.wait(50); !events.empty()) return events.front();
  return {};
}

TEST(LineSocket, LinesGoBothWaysWholeAndInOrder)
{
  LineServer server;
  LineSocket first = reach(server), second = reach(server);
  const std::string large(20000, 'x');
  ASSERT_TRUE(second.send(large));
  const LineServer::Event of_second = next_of(server);
  EXPECT_EQ(of_second.line, large);
  ASSERT_TRUE(first.send("one\ntwo") && first.send(""));
  std::vector<std::string> lines;
  int who = 0;
  while (lines.size() < 3)
    for (const auto& event : server.wait(1000)) lines.push_back(event.line), who = event.who;
  EXPECT_THAT(lines, ElementsAre("one", "two", ""));
  EXPECT_NE(who, of_second.who);
  EXPECT_TRUE(server.send(who, "answer") && server.send(who, "end"));
  std::string line;
  EXPECT_EQ(second.receive(line, 20), Got::nothing) << "it was for the other";
  EXPECT_EQ(first.receive(line, 1000), Got::line);
  EXPECT_EQ(line, "answer");
  EXPECT_EQ(first.receive(line, 1000), Got::line);
  EXPECT_EQ(line, "end");
}

TEST(LineSocket, WhatWasSentBeforeAnEndClosedStillComes)
{
  std::optional<LineServer> server(std::in_place);
  LineSocket socket = reach(*server);
  ASSERT_TRUE(socket.send("hello"));
  const int who = next_of(*server).who;
  EXPECT_FALSE(socket.other_end_closed());
  server->send(who, "end");
  server.reset();
  std::string line;
  EXPECT_EQ(socket.receive(line, 1000), Got::line);
  EXPECT_EQ(line, "end");
  EXPECT_TRUE(socket.other_end_closed());
  EXPECT_EQ(socket.receive(line, 1000), Got::gone);
  EXPECT_FALSE(connect_to("127.0.0.1", 1, 100)) << "nobody listens there";
}

TEST(LineSocket, AProcessThatIsKilledIsNoticed)
{
  LineServer server;
  const pid_t child = ::fork();
  if (child == 0) {
    LineSocket socket = reach(server);
    socket.send("half a line follows");
    ::send(socket.descriptor(), "half", 4, 0);
    ::raise(SIGKILL);
  }
  std::vector<LineServer::Event> came;
  for (int k = 0; k < 40 && came.size() < 2; ++k)
    for (const LineServer::Event& event : server.wait(50)) came.push_back(event);
  ASSERT_THAT(came, SizeIs(2));
  EXPECT_EQ(came[0].line, "half a line follows");
  EXPECT_EQ(came[1].got, Got::gone);
  EXPECT_EQ(came[1].who, came[0].who);
  EXPECT_FALSE(server.send(came[1].who, "anybody"));
  ::waitpid(child, nullptr, 0);
}

TEST(LineSocket, WhatSendsNoLinesIsDropped)
{
  LineServer server;
  LineSocket socket = reach(server);
  const std::string block(100000, 'x');
  for (int k = 0; k < 12; ++k) {
    ::send(socket.descriptor(), block.data(), block.size(), MSG_NOSIGNAL);
    for (const auto& event : server.wait(20))
      if (event.got == Got::gone) return;
  }
  EXPECT_EQ(next_of(server).got, Got::gone);
}

TEST(LineSocket, TheAddressThatLeadsToTheMachineItselfIsLast)
{
  EXPECT_EQ(own_addresses().back(), "127.0.0.1");
  EXPECT_FALSE(machine_name().empty());
}

}  // namespace line_socket_test
