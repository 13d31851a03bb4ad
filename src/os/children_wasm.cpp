#include "os/children.hpp"

#include "math/errors.hpp"

namespace terp {

struct Children::Processes {};

Children::Children(std::size_t)
{
  throw FileError("a page of a browser starts no processes: this command needs Terp on a machine");
}

Children::~Children() = default;
void* Children::shared() { return nullptr; }
void Children::begin(std::size_t, const std::string&, const std::function<int()>&) {}
std::optional<ChildEnd> Children::next_end() { return std::nullopt; }
void Children::ask_to_stop() {}
std::optional<OwnTask> own_task() { return std::nullopt; }

}  // namespace terp
