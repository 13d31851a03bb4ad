// How much disk and processor time the results of a run will take, before it runs: for `terp check`.
#pragma once

#include "model/parts/model.hpp"
#include "run/loop/state.hpp"

namespace terp {

/// An estimate within a factor of 2: how well frames are compressed depends on what happens.
struct OutputCost {
  std::int64_t n_frames = 0, n_checkpoints = 0, n_ledger_rows = 0, n_history_rows = 0;  ///< written in the run
  std::int64_t n_kept = 0;                                                              ///< checkpoints that stay
  double frame_bytes = 0.0;                                                             ///< of one
  double checkpoint_bytes = 0.0;                                                        ///< of one
  double bytes = 0.0;    ///< in the run folder at the end
  double seconds = 0.0;  ///< of one processor, to write all of it and to walk over the points for rows
};

OutputCost estimate_output(const Model& model, const State& state);

}  // namespace terp
