#include "os/say.hpp"

#include <cerrno>
#include <system_error>

namespace terp {
namespace {

int first_fault = 0;  ///< errno of the first text for standard output that could not be written

}  // namespace

void say_text(std::FILE* to, fmt::string_view text, fmt::format_args args)
{
  try {
    fmt::vprint(to, text, args);
  } catch (const std::system_error& error) {
    if (to == stdout && first_fault == 0) first_fault = error.code().value();
  }
}

int why_output_is_lost()
{
  if (first_fault != 0) return first_fault;
  errno = 0;
  return std::fflush(stdout) == 0 && std::ferror(stdout) == 0 ? 0 : errno != 0 ? errno : EIO;
}

}  // namespace terp
