// Printing for people. It never throws: a run does not end because nobody reads what it says, and a warning that cannot
// be written is dropped.
#pragma once

#include <fmt/format.h>

#include <cstdio>

namespace terp {

void say_text(std::FILE* to, fmt::string_view text, fmt::format_args args);

template <class... Arguments>
void say(std::FILE* to, fmt::format_string<Arguments...> text, Arguments&&... arguments)
{
  say_text(to, text, fmt::make_format_args(arguments...));
}

template <class... Arguments>
void say(fmt::format_string<Arguments...> text, Arguments&&... arguments)
{
  say_text(stdout, text, fmt::make_format_args(arguments...));
}

/// Why something that was said on standard output is lost, as errno has it; 0: all is written. The last call of a
/// program, as it writes what still waits.
int why_output_is_lost();

}  // namespace terp
