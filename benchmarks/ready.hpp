// The paper's column, some steps on its way, for the benchmarks.
#pragma once

#include "run/measure/followers.hpp"
#include "io/case/case_file.hpp"
#include "mpm/step/cell_passes.hpp"
#include "run/report/ledger.hpp"
#include "model/parts/setup.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

namespace terp {

/// The paper's column, model 2, on cells of this size [m].
inline Case column(const std::string& scheme, double cell)
{
  return read_case(
      TERP_SOURCE_DIR "/cases/column_collapse/model_2.toml", {"scheme=" + scheme, fmt::format("mesh.cell={}", cell)})
      .values;
}

struct Ready {
  Model model;
  State state;
  Workspace work;
  Ready(const std::string& scheme, double cell, int n_steps)
      : model(build_model(column(scheme, cell), 1)), state(build_state(model)), work(model, state)
  {
    model.followers = all_followers();
    start_followers(model, state);
    for (int k = 0; k < n_steps; ++k) model.step(model, state, work);
  }
};

inline void count_points(benchmark::State& bench, const Ready& ready)
{
  bench.SetItemsProcessed(bench.iterations() * ready.state.points.n_points());
}

}  // namespace terp
