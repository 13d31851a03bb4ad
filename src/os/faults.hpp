// Faults that the system reports of a call.
// Not for: exceptions, and exit() (guarded_call.hpp).
#pragma once

#include <string>

namespace terp {

/// Calls f(argument). Returns "" or in words what the system stopped it for, as an access to memory that is not there.
/// After abort(), or a fault inside the C library, nobody can ask for memory: then it calls end(why), which must end
/// the program without that.
std::string call_with_faults(void (*f)(void*), void* argument, void (*end)(const char* why));

}  // namespace terp
