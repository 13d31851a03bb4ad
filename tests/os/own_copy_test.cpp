#include "os/own_copy.hpp"

#include "support/test.hpp"

#include <csignal>
#include <cstdlib>
#include <functional>
#include <sys/wait.h>
#include <unistd.h>

namespace own_copy_test {

struct Answer {
  int number = 1;
  bool was_copy = false;
};

std::string ask(const std::function<void(Answer&)>& task, Answer& answer, double limit_s = 30.0)
{
  return call_in_copy([&](void* result) { task(*static_cast<Answer*>(result)); }, &answer, sizeof answer, limit_s);
}

TEST(OwnCopy, HandsOnWhatItWroteAndNothingElse)
{
  int beside = 1;
  Answer answer;
  EXPECT_EQ(ask([&](Answer& a) { a = {a.number + 4, is_copy()}, beside = 2; }, answer), "");
  EXPECT_EQ(answer.number, 5);
  EXPECT_TRUE(answer.was_copy);
  EXPECT_EQ(beside, 1);
  EXPECT_FALSE(is_copy());
  EXPECT_EQ(ask([](Answer&) { throw std::runtime_error("lost"); }, answer), "");
}

TEST(OwnCopy, ThatIsNotThroughIsAFaultWhateverItsStatus)
{
  const struct {
    void (*task)(Answer&);
    const char* fault;
  } rows[] = {{[](Answer& a) { a.number = 2, ::_exit(0); }, "ended before its time, as by STOP, XIT or exit"},
      {[](Answer& a) { a.number = 2, std::exit(0); }, "ended before its time, as by STOP, XIT or exit"},
      {[](Answer& a) { a.number = 2, std::raise(SIGKILL); }, "was ended by signal 9 (Killed)"}};
  for (const auto& [task, fault] : rows) {
    Answer answer;
    EXPECT_EQ(ask(task, answer), fault);
    EXPECT_EQ(answer.number, 1);
  }
}

TEST(OwnCopy, ThatNeverEndsIsEndedWithWhatItStarted)
{
  std::array<int, 2> pipe{};
  ASSERT_EQ(::pipe(pipe.data()), 0);
  Answer answer;
  EXPECT_EQ(ask(
                [](Answer&) {
                  ::fork();
                  for (;;) ::pause();
                },
                answer, 0.2),
      "did not come to an end within 0.2 s: it may loop");
  ::close(pipe[1]);
  char none = 0;
  EXPECT_EQ(::read(pipe[0], &none, 1), 0) << "nobody has the other end any more";
  ::close(pipe[0]);
}

TEST(OwnCopy, IsCountedAlsoWhereItWasMadeByFork)
{
  const int before = fork_count();
  int status = 0;
  if (::fork() == 0) ::_exit(fork_count() - before);
  ASSERT_GT(::wait(&status), 0);
  EXPECT_EQ(WEXITSTATUS(status), 1);
  EXPECT_EQ(fork_count(), before);
  Answer answer;
  EXPECT_EQ(ask([](Answer& a) { a.number = ::fork() == 0 ? 3 : (::wait(nullptr), 2); }, answer), "");
  EXPECT_EQ(answer.number, 2) << "its copy came to the end first, and does not count";
}

}  // namespace own_copy_test
