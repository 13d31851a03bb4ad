// Whether a law of a library returns while steps are made.
#pragma once

#include "os/watch.hpp"
#include "model/case/case.hpp"
#include "run/loop/observer.hpp"

#include <atomic>
#include <functional>
#include <memory>
#include <string>

namespace terp {

/// Tells where the steps of soil of a library do not go on: a law may loop without end, and nothing else would say so.
class LibraryWatch : public Observer {
 public:
  static constexpr double usual_limit_s = 60.0;

  /// tell: called in another thread, where nothing was heard for limit_s, or 20 times the longest pause before. A case
  /// without such soil is not watched.
  LibraryWatch(const Case& c, std::function<void(const std::string&)> tell, double limit_s = usual_limit_s);
  /// Steps were made; step: of the last one.
  void hear(std::int64_t step);
  void progress(const Progress& now) override { hear(now.step); }

 private:
  std::string laws_;  ///< in words
  std::function<void(const std::string&)> tell_;
  std::atomic<std::int64_t> step_ = 0;
  std::unique_ptr<Watch> watch_;  // last: it uses the rest
};

}  // namespace terp
