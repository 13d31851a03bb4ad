// How it thinks: realisations are numbered in the order in which the method asks for them, and the method is the same
// each time. So the store is enough to go through it again: what it asks for is there, under the next number, until the
// first that is missing.

#include "batch/adaptive.hpp"

#include "math/errors.hpp"
#include "io/case/case_file.hpp"

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

struct NotKept {};
struct Ended {
  StudyEnd why;
};

ReliabilityRule rule_of(const StudySettings& s)
{
  return {.kind = s.estimator,
      .n_numbers = s.numbers.size(),
      .seed = s.seed,
      .number = s.stop.number,
      .block = s.adaptive.block,
      .cov = s.stop.cov};
}

/// Takes what is kept, and lets `solve` make the rest of a block: numbers from `first` on.
class Replay {
 public:
  using Solve = std::function<void(Index first, const std::vector<Draw>& draws)>;
  Replay(const Study& study, const Realisations& rows, Solve solve)
      : study_(study), rows_(rows), solve_(std::move(solve))
  {
  }

  std::vector<Real> operator()(const std::vector<std::vector<Real>>& scores)
  {
    std::vector<Draw> draws;
    for (const std::vector<Real>& place : scores) draws.push_back(draw_at(study_, place));
    const Index first = next_;
    next_ += static_cast<Index>(draws.size());
    if (next_ > study_.n_realisations)
      throw MethodFault(std::to_string(study_.n_realisations) +
                        " realisations are not enough for the method: the event is rarer than it finds, or nothing "
                        "changes with the input. See results.csv.");
    for (Index n = first; n < next_; ++n)
      if (!rows_.contains(n)) {
        solve_(first, draws);
        break;
      }
    std::vector<Real> values;
    for (Index n = first; n < next_; ++n) {
      const auto row = rows_.find(n);
      if (row == rows_.end()) throw NotKept{};
      if (row->second.inputs != draws[static_cast<std::size_t>(n - first)].inputs)
        throw FileError("realisation " + std::to_string(n) +
                        " was solved at another place than the method asks for\n  It was solved by another program or "
                        "machine, or with another version of OpenTURNS. Begin anew: --force");
      values.push_back(limit_state_of(study_.settings, row->second));
    }
    return values;
  }

 private:
  const Study& study_;
  const Realisations& rows_;
  Solve solve_;
  Index next_ = 0;
};

}  // namespace

Real limit_state_of(const StudySettings& settings, const Realisation& r)
{
  if (!r.solved() || (settings.adaptive.of_flood && !r.judges_flood)) return -1.0;  // as adaptive.hpp says
  constexpr Real least = 1e-12, above = 1e-9;
  const auto outcome = [&](const char* name) { return r.outcomes[outcome_number(name)]; };
  const Real decades = std::log10(settings.event.displacement / std::max(least, outcome("event_displacement")));
  if (!settings.adaptive.of_flood) return r.slid ? std::min(decades, 0.0) : std::max(decades, above);
  const Real freeboard = outcome("freeboard");
  if (!std::isfinite(freeboard)) return -1.0;  // no ground is left
  const Real distance = freeboard + std::max(decades, 0.0);
  return r.flooded ? std::min(distance, 0.0) : std::max(distance, above);
}

StudyEnd run_adaptive(const Study& study, const std::string& folder, const EngineOptions& options,
    const std::atomic<bool>& stop, Realisations& rows)
{
  const auto solve = [&](Index first, const std::vector<Draw>& draws) {
    std::vector<Index> numbers;
    for (Index n = first; n < first + static_cast<Index>(draws.size()); ++n) numbers.push_back(n);
    const StudyEnd end = solve_realisations(
        study, folder, options, stop, numbers, [&](Index n) { return draws[static_cast<std::size_t>(n - first)]; },
        rows);
    if (end != StudyEnd::rule_met) throw Ended{end};
  };
  try {
    find_probability(rule_of(study.settings), Replay(study, rows, solve));
    return StudyEnd::rule_met;
  } catch (const Ended& ended) {
    return ended.why;
  } catch (const MethodFault&) {
    return StudyEnd::rule_met;  // the report says why
  }
}

AdaptiveFound replay_adaptive(const Study& study, const Realisations& rows)
{
  try {
    return {.result = find_probability(rule_of(study.settings),
                Replay(study, rows, [](Index, const std::vector<Draw>&) { throw NotKept{}; }))};
  } catch (const NotKept&) {
    return {};
  } catch (const MethodFault& fault) {
    return {.fault = fault.what()};
  }
}

}  // namespace terp
