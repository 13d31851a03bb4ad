// The sizes were measured on the paper's column with 160 000 points, and a test holds them to a factor of two. The
// times are estimates that no measurement backs yet.

#include "run/report/output_costs.hpp"

#include "run/report/frame.hpp"

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

constexpr double bytes_of_frame_value = 3.1;       // a 32-bit number, compressed
constexpr double bytes_of_checkpoint_value = 8.0;  // a 64-bit number
constexpr double bytes_of_ledger_row = 340.0, bytes_of_history_row = 110.0;
constexpr double seconds_of_frame_value = 60e-9, seconds_of_checkpoint_value = 10e-9;
constexpr double seconds_of_point_in_row = 20e-9;
constexpr int values_beside_rows = 8;  // of a point in a checkpoint: cell, material, first place, history, flags

/// Times from 0 to the end, both included.
std::int64_t count_times(const Model& model, Real every)
{
  if (every <= 0.0) return 2;
  const Real n = std::ceil(model.description.time.end / every * (1.0 - 1e-9));
  return std::min(static_cast<std::int64_t>(n), model.n_steps) + 1;
}

}  // namespace

OutputCost estimate_output(const Model& model, const State& state)
{
  const OutputCase& output = model.description.output;
  const auto points = static_cast<double>(state.n_ids());
  double frame_values = 2.0;  // the place
  for (const PointField& field : make_frame(model, state, 0, 0).fields) frame_values += field.n_components;
  const double checkpoint_values = state.points.n_rows() + values_beside_rows;

  OutputCost cost;
  cost.n_frames = count_times(model, output.fields_every);
  cost.n_checkpoints = count_times(model, output.checkpoint_every) - 1;
  cost.n_kept = output.checkpoint_keep > 0 ? std::min<std::int64_t>(output.checkpoint_keep, cost.n_checkpoints)
                                           : cost.n_checkpoints;
  cost.n_ledger_rows = count_times(model, output.ledger_every);
  cost.n_history_rows = count_times(model, output.history_every) * std::ssize(output.history_points);
  cost.frame_bytes = points * frame_values * bytes_of_frame_value;
  cost.checkpoint_bytes = points * checkpoint_values * bytes_of_checkpoint_value;

  const auto frames = static_cast<double>(cost.n_frames), rows = static_cast<double>(cost.n_ledger_rows);
  cost.bytes = frames * cost.frame_bytes + static_cast<double>(cost.n_kept) * cost.checkpoint_bytes +
               rows * bytes_of_ledger_row + static_cast<double>(cost.n_history_rows) * bytes_of_history_row;
  cost.seconds =
      points * (frames * frame_values * seconds_of_frame_value +
                   static_cast<double>(cost.n_checkpoints) * checkpoint_values * seconds_of_checkpoint_value +
                   rows * seconds_of_point_in_row);
  return cost;
}

}  // namespace terp
