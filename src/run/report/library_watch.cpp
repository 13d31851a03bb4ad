#include "run/report/library_watch.hpp"

#include <fmt/format.h>

namespace terp {

LibraryWatch::LibraryWatch(const Case& c, std::function<void(const std::string&)> tell, double limit_s)
    : tell_(std::move(tell))
{
  for (const MaterialCase& material : c.materials)
    if (material.from_library != nullptr)
      laws_ += fmt::format("{}`{}` ({})", laws_.empty() ? "" : ", ", material.name, material.library.file);
  if (laws_.empty()) return;
  watch_ = std::make_unique<Watch>(limit_s, [this](double seconds) {
    tell_(fmt::format(
        "no step was made for {:.3g} s, the last one was step {}: a law of a library may loop without end, {}\n"
        "  Ctrl-C twice, a second apart, ends it. What was written stays, as do the checkpoints.",
        seconds, step_.load(), laws_));
  });
}

void LibraryWatch::hear(std::int64_t step)
{
  step_ = step;
  if (watch_ != nullptr) watch_->hear();
}

}  // namespace terp
