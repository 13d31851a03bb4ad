// What `terp --help` and `terp COMMAND --help` print.
// Not for: what the commands take (main), keys and materials (input/explain).
#pragma once

#include <string_view>

namespace terp {

/// The page of the program.
std::string_view help();

/// The page of a command; that of the program for a word that is none.
std::string_view help_on(std::string_view command);

}  // namespace terp
