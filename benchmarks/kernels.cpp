// Google Benchmark of what the step is made of and of what surrounds it. Laws and steps come from the copy of the
// kernels that this processor gets (TERP_INSTRUCTIONS forces one). `items_per_second` counts points.

#include "ready.hpp"
#include "run/report/frame.hpp"
#include "run/report/state_image.hpp"

#include <chrono>

namespace terp {
namespace {

void Step(benchmark::State& bench, const char* scheme)
{
  Ready ready(scheme, 0.1, 200);
  for (auto _ : bench) ready.model.step(ready.model, ready.state, ready.work);
  count_points(bench, ready);
}
BENCHMARK_CAPTURE(Step, mpm_gp, "mpm_gp")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(Step, mpm_mixed, "mpm_mixed")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(Step, standard_mpm, "standard_mpm")->Unit(benchmark::kMicrosecond);

void LedgerRowOfAllPoints(benchmark::State& bench)
{
  Ready ready("mpm_gp", 0.1, 3000);  // flowing
  for (auto _ : bench) {             // as in a run: the caches hold what the step left
    ready.model.step(ready.model, ready.state, ready.work);
    const auto start = std::chrono::steady_clock::now();
    benchmark::DoNotOptimize(keep_ledger(ready.model, ready.state, ready.work));
    bench.SetIterationTime(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  count_points(bench, ready);
}
BENCHMARK(LedgerRowOfAllPoints)->UseManualTime()->Iterations(600)->Unit(benchmark::kMicrosecond);

void FrameOfAllFields(benchmark::State& bench)
{
  Ready ready("mpm_gp", 0.1, 200);
  for (auto _ : bench) benchmark::DoNotOptimize(make_frame(ready.model, ready.state));
  count_points(bench, ready);
}
BENCHMARK(FrameOfAllFields)->Unit(benchmark::kMicrosecond);

void ImageForACheckpoint(benchmark::State& bench)
{
  Ready ready("mpm_gp", 0.1, 200);
  for (auto _ : bench) benchmark::DoNotOptimize(make_image(ready.state));
  count_points(bench, ready);
}
BENCHMARK(ImageForACheckpoint)->Unit(benchmark::kMicrosecond);

void ModelAndStateFromACase(benchmark::State& bench)
{
  const Case description = column("mpm_gp", 0.1);
  std::int64_t n = 0;
  for (auto _ : bench) {
    Model model = build_model(description, 1);
    n += build_state(model).points.n_points();
  }
  bench.SetItemsProcessed(n);
}
BENCHMARK(ModelAndStateFromACase)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace terp

BENCHMARK_MAIN();
