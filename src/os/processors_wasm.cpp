#include "os/instructions.hpp"
#include "os/threads.hpp"

namespace terp {

int available_processors() { return 1; }

std::string processor_name() { return "a page of a browser, 1 processor"; }

}  // namespace terp
