// Options of terp import that would have no effect.
#pragma once

#include "commands.hpp"

namespace terp {

/// Throws CaseError if an option is of the other kind of file, or of the other of list and case folder.
void refuse_unused_options(const ImportCommand& command, bool is_drawing);

}  // namespace terp
