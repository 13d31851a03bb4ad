// The table of keys as a JSON Schema of the case file (draft 7): editors complete keys, show their meaning and mark
// what is wrong. Not for: what keys contradict among each other; `terp check` says that.
#pragma once

#include <string>

namespace terp {

/// What `terp schema` prints.
std::string case_schema();

}  // namespace terp
