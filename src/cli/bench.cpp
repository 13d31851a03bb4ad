// All trials go on with the same simulation, so each begins where the one before ended. The passes are those of the
// median trial, so that they belong to its total. Their bound comes from what one thread can do here, measured just
// before, times the number of threads. The memory in which the points lie, by their bytes, sets the rate.

#include "mpm/step/score_places.hpp"
#include "cli/commands.hpp"
#include "io/case/case_file.hpp"
#include "io/case/printable.hpp"
#include "os/instructions.hpp"
#include "mpm/step/kernels.hpp"
#include "mpm/step/passes.hpp"
#include "mpm/step/score.hpp"
#include "mpm/step/workspace.hpp"
#include "run/loop/simulation.hpp"
#include "os/say.hpp"

#include <algorithm>
#include <chrono>
#include <fmt/format.h>

namespace terp {
namespace {

constexpr const char* standard_case = R"(
title = "the paper's column, model 2"
[time]
end = 4.0
[mesh]
size = [16.0, 3.0]
cell = 0.1
[[body]]
material = "clay"
box = [[0.0, 0.0], [8.0, 2.0]]
[material.clay]
model = "tresca_softening"
density = 1990.0
shear_modulus = 2.0e6
poisson_ratio = 0.48
su_peak = 8.0e3
su_residual = 2.0e3
eta = 50.0
[forces]
gravity = [0.0, -9.81]
damping = { local = 0.1 }
[boundary]
left = "roller"
right = "roller"
bottom = { contact = "bilateral", adhesion = 8.0e3 }
)";

struct Measurement {
  double seconds = 0.0;                 // of the median trial
  std::vector<double> passes;           // of the same trial
  double fastest = 0.0, slowest = 0.0;  // trials
};

/// Steps alone: no start, no outputs.
void step(Simulation& s, std::int64_t n)
{
  if (const StepsMade made = make_steps(s.model, s.state, s.work, {.most_steps = n}); made.end == LoopEnd::fault)
    throw RunError(made.fault);
}

Measurement measure(Simulation& s, std::int64_t n_steps, std::int64_t warm)
{
  constexpr int trials = 5;
  step(s, warm);
  std::vector<Measurement> all;
  for (int trial = 0; trial < trials; ++trial) {
    s.work.seconds.assign(n_passes, 0.0);
    const auto start = std::chrono::steady_clock::now();
    step(s, n_steps);
    all.push_back(
        {std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), s.work.seconds, 0.0, 0.0});
  }
  std::ranges::sort(all, [](const auto& a, const auto& b) { return a.seconds < b.seconds; });
  Measurement median = all[trials / 2];
  median.fastest = all.front().seconds;
  median.slowest = all.back().seconds;
  return median;
}

struct Machine {
  double triad_cache = kernels().measure_triad(512u << 10), triad_l3 = kernels().measure_triad(12u << 20);
  double triad_memory = kernels().measure_triad(384u << 20), multiply_add = kernels().measure_multiply_add();
};

/// Rate that bounds a pass: of the memory in which the points lie [GB/s per thread].
double stream_rate(const Machine& machine, std::int64_t bytes)
{
  if (bytes < (1 << 20)) return machine.triad_cache;
  return bytes < (24 << 20) ? machine.triad_l3 : machine.triad_memory;
}

struct PassReport {
  double ns_per_point, flops, bytes, roofline;
};

std::vector<PassReport> report_passes(
    const Model& model, const State& state, const Measurement& m, const Machine& machine, std::int64_t n_steps)
{
  const auto costs = pass_costs(*model.scheme);
  const double points = static_cast<double>(state.points.n_points()) * static_cast<double>(n_steps);
  const double rate = stream_rate(machine, state.points.bytes()) * model.threads,
               peak = machine.multiply_add * model.threads;
  std::vector<PassReport> reports;
  for (int pass = 0; pass < n_passes; ++pass) {
    const double ns = m.passes[pass] / points * 1e9;
    const double bound = std::max(costs[pass].bytes() / rate, costs[pass].flops / peak);  // ns per point
    reports.push_back({ns, costs[pass].flops, costs[pass].bytes(), ns > 0.0 ? bound / ns : 0.0});
  }
  return reports;
}

void print_text(
    const Model& model, const State& state, const Measurement& m, const Machine& machine, std::int64_t n_steps)
{
  const double points = static_cast<double>(state.points.n_points()) * static_cast<double>(n_steps);
  say("{}, {}, {} points, {} thread{}, {}, double\n", printable(model.description.title), model.description.scheme,
      state.points.n_points(), model.threads, model.threads == 1 ? "" : "s", instructions());
  say("  {:.1f} M point-steps/s (median of 5 x {} steps; {:.1f} to {:.1f})\n", points / m.seconds / 1e6, n_steps,
      points / m.slowest / 1e6, points / m.fastest / 1e6);
  say("  {:.0f} bytes per point\n\n",
      static_cast<double>(state.points.bytes()) / static_cast<double>(state.points.n_points()));
  say("  pass              ns/point   flops   bytes  of the roofline\n");
  const auto passes = report_passes(model, state, m, machine, n_steps);
  for (int pass = 0; pass < n_passes; ++pass) {
    const PassReport& r = passes[pass];
    say("  {:<16} {:9.2f} {:7.0f} {:7.0f} {:>8}\n", pass_names[pass], r.ns_per_point, r.flops, r.bytes,
        r.roofline > 0.0 ? fmt::format("{:.0f} %", 100.0 * r.roofline) : "-");
  }
  say("\n  machine, one thread: triad {:.0f} GB/s in L2, {:.0f} in L3, {:.0f} in memory; multiply-add {:.0f} GFLOP/s\n",
      machine.triad_cache, machine.triad_l3, machine.triad_memory, machine.multiply_add);
}

void print_json(
    const Model& model, const State& state, const Measurement& m, const Machine& machine, std::int64_t n_steps)
{
  const double points = static_cast<double>(state.points.n_points()) * static_cast<double>(n_steps);
  say("{{\"terp_version\": \"{}\", \"scheme\": \"{}\", \"points\": {}, \"cells\": {}, \"threads\": {}, "
      "\"instructions\": \"{}\",\n",
      TERP_VERSION, model.description.scheme, state.points.n_points(), model.mesh->n_cells(), model.threads,
      instructions());
  say(" \"point_steps_per_s\": {}, \"slowest\": {}, \"fastest\": {}, \"bytes_per_point\": {},\n", points / m.seconds,
      points / m.slowest, points / m.fastest,
      static_cast<double>(state.points.bytes()) / static_cast<double>(state.points.n_points()));
  say(" \"triad_gb_per_s\": [{}, {}, {}], \"multiply_add_gflops\": {},\n \"passes\": [", machine.triad_cache,
      machine.triad_l3, machine.triad_memory, machine.multiply_add);
  const auto passes = report_passes(model, state, m, machine, n_steps);
  for (int pass = 0; pass < n_passes; ++pass)
    say("{}\n  {{\"name\": \"{}\", \"ns_per_point\": {}, \"flops\": {}, \"bytes\": {}, \"roofline\": {}}}",
        pass == 0 ? "" : ",", pass_names[pass], passes[pass].ns_per_point, passes[pass].flops, passes[pass].bytes,
        passes[pass].roofline);
  say("]}}\n");
}

/// In the order of Over.
constexpr std::string_view over_words[] = {"once", "group", "layer", "block", "strip", "nodes", "wait"};

/// What a step of the case does: walk by walk, each place with who has a kernel there. Kernels within a law stand last.
void print_score(const Model& model, const Score& score)
{
  say("{}, {}, {} kernels in {} walks\n", printable(model.description.title), model.description.scheme, score.n_kernels,
      score.n_walks);
  const auto print = [](std::span<const Kernel* const> kernels) {
    for (std::size_t k = 0, next; k < kernels.size(); k = next) {
      const PlaceInfo& place = score_places[static_cast<std::size_t>(kernels[k]->place)];
      std::string who;
      for (next = k; next < kernels.size() && kernels[next]->place == kernels[k]->place; ++next)
        who += (who.empty() ? "" : "; ") + std::string(kernels[next]->name);
      say("    {:<7} {:<16} {} [{}]\n", over_words[static_cast<std::size_t>(place.over)], place.name, place.text, who);
    }
  };
  for (const ScoreWalk& walk : std::span(score.walks).first(score.n_walks)) {
    say("  {}\n", walk.pass == n_passes ? "once" : pass_names[walk.pass]);
    for (const ScoreSegment& segment : score.of(walk)) print(score.of(segment));
  }
  if (score.n_strips > 0) say("  within the law of a block\n");
  print(score.strips());
}

}  // namespace

int bench_case(const RunOptions& options)
{
  const CaseFile file = options.path.empty() ? read_case_text(standard_case, "bench", options.changes)
                                             : read_case(options.path, options.changes);
  try {
    Simulation s(file.values, threads_of(options));
    if (options.score) {
      print_score(s.model, kernels().score(s.model, s.work));
      return solved;
    }
    warn_of_missing_threads(options, s.model.threads);
    const Machine machine;
    const Measurement m = measure(s, options.steps, options.warm_steps);
    (options.json ? print_json : print_text)(s.model, s.state, m, machine, options.steps);
    return solved;
  } catch (const InputError& error) {
    throw CaseError(render(error.problems(), file));
  }
}

}  // namespace terp
