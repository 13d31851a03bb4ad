#include "os/process.hpp"

namespace terp {

ProcessResult run_process(
    const std::vector<std::string>&, double, const std::vector<std::string>&, const std::function<void(double)>&)
{
  return {};
}

std::string how_to_install(const std::string& package, const std::string&)
{
  return package + " is a program, which a page of a browser cannot start: use Terp on a machine";
}

struct SignalsHeld::Held {};
SignalsHeld::SignalsHeld() = default;
SignalsHeld::~SignalsHeld() = default;

}  // namespace terp
