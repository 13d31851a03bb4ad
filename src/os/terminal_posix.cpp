#include "os/terminal.hpp"

#include <csignal>
#include <fcntl.h>
#include <initializer_list>
#include <poll.h>
#include <unistd.h>

namespace terp {

/// POSIX hands out the lowest free number, so each stream that is opened fills the gap.
bool prepare_standard_streams()
{
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(descriptor, F_GETFD) < 0 && ::open("/dev/null", O_RDWR) != descriptor) return false;
  std::signal(SIGPIPE, SIG_IGN);
  return true;
}

bool is_terminal(std::FILE* stream) { return ::isatty(::fileno(stream)) == 1; }

void wait_seconds(double seconds) { ::poll(nullptr, 0, static_cast<int>(1e3 * seconds)); }

}  // namespace terp
