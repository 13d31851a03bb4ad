// Faults that the system reports of a call.
// Not for: exceptions, and exit() (guarded_call.hpp).
#pragma once

#include <string>

namespace terp {

/// Calls f(argument). Returns "" or in words what the system stopped it for, as an access to memory that is not there.
std::string call_with_faults(void (*f)(void*), void* argument);

}  // namespace terp
