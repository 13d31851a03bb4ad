// A process that the system grants no further thread, as under `ulimit -u`.
#pragma once

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace terp::test {

/// Runs f in a child process that can start no thread; f returns the exit status. -1: the limit could not be set.
template <class F>
int status_without_threads(F&& f)
{
  const pid_t child = ::fork();
  if (child == 0) {
    const rlimit none{0, 0};
    if (::setrlimit(RLIMIT_NPROC, &none) != 0) ::_exit(255);
    if (::geteuid() == 0 && ::setuid(65534) != 0) ::_exit(255);  // the limit does not hold for root
    ::_exit(f());
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) != 255 ? WEXITSTATUS(status) : -1;
}

}  // namespace terp::test
