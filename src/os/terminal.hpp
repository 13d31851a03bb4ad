// Standard input, output and error, and waiting.
#pragma once

#include <cstdio>

namespace terp {

/// Gives standard input, output and error a place if whoever started us closed them: a table would get their numbers
/// otherwise, and with it all that we print. A reader that has gone ends no program. On Windows texts are UTF-8 from
/// here on, and lines end as on Linux. False: it cannot, and nobody could be told.
bool prepare_standard_streams();

/// Whether a person sees what is written there, on a terminal.
bool is_terminal(std::FILE* stream);

/// A signal may end it early.
void wait_seconds(double seconds);

}  // namespace terp
