#include "os/stop.hpp"
#include "support/test.hpp"
#include <csignal>
#include <sys/wait.h>
#include <unistd.h>

namespace stop_test {

struct Sent {
  int signal;
  int wait_ms;  ///< before it is sent
};

/// The signal that ended a process which gets these and then ends itself; 0: it was asked to stop; -1: it was not.
int end_of_listener(const std::vector<Sent>& signals)
{
  int ms = 200;
  for (const Sent& sent : signals) ms += sent.wait_ms;
  int ready[2];
  if (::pipe(ready) != 0) return -1;
  const pid_t child = ::fork();
  if (child == 0) {
    listen_for_stop();
    char byte = 'r';
    if (::write(ready[1], &byte, 1) != 1) ::_exit(2);
    for (int k = 0; k < ms; ++k) ::usleep(1000);  // longer than the signals take
    ::_exit(stop_requested ? 0 : 1);
  }
  char byte = 0;
  EXPECT_EQ(::read(ready[0], &byte, 1), 1);
  for (const Sent& sent : signals) ::usleep(static_cast<useconds_t>(1000 * sent.wait_ms)), ::kill(child, sent.signal);
  int status = 0;
  ::waitpid(child, &status, 0);
  ::close(ready[0]), ::close(ready[1]);
  if (WIFSIGNALED(status)) return WTERMSIG(status);
  return WEXITSTATUS(status) == 0 ? 0 : -1;
}

TEST(Stop, IsAskedForByTheFirstSignal)
{
  for (const int signal : {SIGINT, SIGQUIT, SIGTERM, SIGUSR1, SIGUSR2, SIGXCPU, SIGHUP})
    EXPECT_EQ(end_of_listener({{signal, 0}}), 0) << signal;
  EXPECT_EQ(end_of_listener({}), -1);
}

TEST(Stop, ARepeatedSignalIsTheSameRequest)
{
  EXPECT_EQ(end_of_listener({{SIGTERM, 0}, {SIGTERM, 100}, {SIGTERM, 1000}}), 0);
  EXPECT_EQ(end_of_listener({{SIGUSR1, 0}, {SIGTERM, 1200}}), 0);
  EXPECT_EQ(end_of_listener({{SIGINT, 0}, {SIGINT, 300}}), 0);
  EXPECT_EQ(end_of_listener({{SIGXCPU, 0}, {SIGXCPU, 1000}, {SIGXCPU, 500}}), 0);
}

TEST(Stop, ALaterKeyPressEndsTheProgramAtOnce)
{
  EXPECT_EQ(end_of_listener({{SIGINT, 0}, {SIGINT, 1200}}), SIGINT);
  EXPECT_EQ(end_of_listener({{SIGTERM, 0}, {SIGINT, 1200}}), SIGINT);
}

}  // namespace stop_test
