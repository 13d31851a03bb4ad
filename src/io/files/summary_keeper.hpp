// Renews the summary of a run with each checkpoint, so that it says how long a run took that is killed later.
#pragma once

#include "io/files/run_writer.hpp"
#include "run/loop/run.hpp"

namespace terp {

/// Connected behind the writer of the same run.
class SummaryKeeper : public Observer {
 public:
  SummaryKeeper(const Model& model, const State& state, RunWriter& writer)
      : model_(model), state_(state), writer_(writer)
  {
  }
  void checkpoint(const std::shared_ptr<const StateImage>& image) override
  {
    if (image->last) writer_.summary(summarise(model_, state_), false);
  }

 private:
  const Model& model_;
  const State& state_;
  RunWriter& writer_;
};

}  // namespace terp
