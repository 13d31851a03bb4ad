#include "os/threads.hpp"

#include "cli/commands.hpp"
#include "os/say.hpp"

#include <fmt/format.h>

namespace terp {

int threads_of(const RunOptions& options) { return options.threads > 0 ? options.threads : available_processors(); }

void warn_of_missing_threads(const RunOptions& options, int granted)
{
  if (granted < threads_of(options))
    say(stderr,
        "warning: the system granted {} of {} threads (ulimit -u); the results are the same, the run takes longer\n",
        granted, threads_of(options));
}

}  // namespace terp
