// What this machine's processor is called: for the record of a run.
#pragma once

#include <string>

namespace terp {

/// "Intel(R) Xeon(R) ..." as the system has it, with the number of processors; empty if the system does not say.
std::string processor_name();

}  // namespace terp
