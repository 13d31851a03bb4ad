// No signals: the page sets the request between parts of a run (cli/main_wasm.cpp).
#include "os/stop.hpp"

namespace terp {

std::atomic<bool> stop_requested{false};

void listen_for_stop() {}

}  // namespace terp
