// How it thinks: the event is a function of independent standard normal variables, so that OpenTURNS has nothing to
// transform. It asks for the function in blocks. A library of its own, built where CMake finds OpenTURNS; it calls
// nothing of Terp but the limit state.

#include "batch/reliability.hpp"

#include <openturns/AbdoRackwitz.hxx>
#include <openturns/CompositeRandomVector.hxx>
#include <openturns/FORM.hxx>
#include <openturns/Function.hxx>
#include <openturns/LessOrEqual.hxx>
#include <openturns/Log.hxx>
#include <openturns/NonCenteredFiniteDifferenceGradient.hxx>
#include <openturns/Normal.hxx>
#include <openturns/RandomGenerator.hxx>
#include <openturns/SubsetSampling.hxx>
#include <openturns/ThresholdEvent.hxx>

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

class Evaluation : public OT::EvaluationImplementation {
 public:
  Evaluation(const LimitState& limit, std::size_t n_numbers, Index& n_places)
      : limit_(&limit), n_numbers_(n_numbers), n_places_(&n_places)
  {
  }
  Evaluation* clone() const override { return new Evaluation(*this); }
  OT::UnsignedInteger getInputDimension() const override { return n_numbers_; }
  OT::UnsignedInteger getOutputDimension() const override { return 1; }
  OT::Point operator()(const OT::Point& place) const override { return (*this)(OT::Sample(1, place))[0]; }
  OT::Sample operator()(const OT::Sample& places) const override
  {
    std::vector<std::vector<Real>> scores(places.getSize(), std::vector<Real>(n_numbers_));
    for (std::size_t i = 0; i < scores.size(); ++i)
      for (std::size_t k = 0; k < n_numbers_; ++k) scores[i][k] = places(i, k);
    const std::vector<Real> values = (*limit_)(scores);
    *n_places_ += static_cast<Index>(values.size());
    OT::Sample out(values.size(), 1);
    for (std::size_t i = 0; i < values.size(); ++i) out(i, 0) = values[i];
    return out;
  }

 private:
  const LimitState* limit_;
  std::size_t n_numbers_;
  Index* n_places_;
};

std::vector<Real> numbers_of(const OT::Point& point) { return {point.begin(), point.end()}; }

OT::ThresholdEvent event_of(const Evaluation& evaluation)
{
  constexpr Real step = 0.1;  // standard deviations: results of runs are not smooth below
  OT::Function function{OT::Evaluation(evaluation)};
  function.setGradient(OT::NonCenteredFiniteDifferenceGradient(step, OT::Evaluation(evaluation)));
  const OT::RandomVector scores{OT::Normal(evaluation.getInputDimension())};
  return OT::ThresholdEvent(OT::CompositeRandomVector(function, scores), OT::LessOrEqual(), 0.0);
}

void find_design_point(const ReliabilityRule& rule, const OT::ThresholdEvent& event, ReliabilityResult& result)
{
  OT::AbdoRackwitz search;
  search.setMaximumEvaluationNumber(static_cast<OT::UnsignedInteger>(rule.number));
  OT::FORM form(search, event, OT::Point(rule.n_numbers));
  form.run();
  const OT::FORMResult found = form.getResult();
  result.probability = found.getEventProbability();
  result.design_point = numbers_of(found.getStandardSpaceDesignPoint());
  const Real square = found.getStandardSpaceDesignPoint().normSquare();
  for (const Real u : result.design_point) result.importance.push_back(square > 0.0 ? u * u / square : 0.0);
}

/// Where levels no longer fall towards the event, OpenTURNS gives the probability of the last one: an upper bound.
void find_by_subsets(const ReliabilityRule& rule, const OT::ThresholdEvent& event, ReliabilityResult& result)
{
  constexpr Real least = 1e-9;  // beyond, no P is worth a run
  OT::SubsetSampling subset(event);
  subset.setMinimumProbability(least);
  subset.setBlockSize(static_cast<OT::UnsignedInteger>(rule.block));
  subset.setMaximumOuterSampling(static_cast<OT::UnsignedInteger>(std::max(fewest_blocks, rule.number / rule.block)));
  const auto last = [](const OT::Point& of_steps) {
    return of_steps.isEmpty() ? 1.0 : of_steps[of_steps.getSize() - 1];
  };
  try {
    subset.run();
  } catch (const OT::Exception&) {  // also of a P below the least
    constexpr Real near = 1e3;      // a level is at least ten times rarer, by chance more
    if (last(subset.getProbabilityEstimatePerStep()) > near * least) throw;
  }
  if (last(subset.getThresholdPerStep()) > 0.0) {
    result.at_most = last(subset.getProbabilityEstimatePerStep());
    return;
  }
  result.probability = subset.getResult().getProbabilityEstimate();
  result.cov = subset.getResult().getCoefficientOfVariation();
}

/// Samples of a normal distribution about the design point c; that at c + z has the weight phi(c + z)/phi(z).
void sample_about_design_point(const ReliabilityRule& rule, const LimitState& limit, ReliabilityResult& result)
{
  const std::vector<Real>& centre = result.design_point;
  const OT::Normal normal(static_cast<OT::UnsignedInteger>(rule.n_numbers));
  Real sum = 0.0, squares = 0.0;
  Index n = 0;
  const Index number = std::max(rule.number, fewest_samples);
  while (n < number) {
    const auto block = static_cast<OT::UnsignedInteger>(std::min(rule.block, number - n));
    const OT::Sample z = normal.getSample(block);
    std::vector<std::vector<Real>> scores(block, centre);
    std::vector<Real> logs(block, 0.0);
    for (std::size_t i = 0; i < block; ++i)
      for (std::size_t k = 0; k < centre.size(); ++k)
        scores[i][k] += z(i, k), logs[i] -= centre[k] * (z(i, k) + 0.5 * centre[k]);
    const std::vector<Real> values = limit(scores);
    for (std::size_t i = 0; i < block; ++i) {
      const Real weight = values[i] <= 0.0 ? std::exp(logs[i]) : 0.0;
      sum += weight, squares += weight * weight;
    }
    n += static_cast<Index>(block);
    const auto all = static_cast<Real>(n);
    result.probability = sum / all;
    if (sum > 0.0) result.cov = std::sqrt(std::max(0.0, squares / (sum * sum) - 1.0 / all));
    if (n >= fewest_samples && result.cov && *result.cov <= rule.cov) break;
  }
  result.n_places += n;
}

ReliabilityResult find(const ReliabilityRule& rule, const LimitState& limit)
{
  ReliabilityResult result;
  const OT::ThresholdEvent event = event_of(Evaluation(limit, rule.n_numbers, result.n_places));
  if (rule.kind == Estimator::subset) {
    find_by_subsets(rule, event, result);
    return result;
  }
  find_design_point(rule, event, result);
  result.converged = std::abs(limit({result.design_point}).front()) < 0.05;
  ++result.n_places;
  if (rule.kind == Estimator::importance_sampling) sample_about_design_point(rule, limit, result);
  return result;
}

}  // namespace
}  // namespace terp

extern "C" __attribute__((visibility("default"))) const std::size_t terp_reliability_layout;
const std::size_t terp_reliability_layout = terp::reliability_layout;

/// What reliability.cpp asks for. Throws MethodFault, and what `limit` throws.
extern "C" __attribute__((visibility("default"))) void terp_find_probability(
    const terp::ReliabilityRule& rule, const terp::LimitState& limit, terp::ReliabilityResult& result)
{
  OT::Log::Show(OT::Log::NONE);
  OT::RandomGenerator::SetSeed(static_cast<OT::UnsignedInteger>(rule.seed));
  try {
    result = terp::find(rule, limit);
  } catch (const OT::Exception& error) {
    throw terp::MethodFault(std::string("OpenTURNS ended the method: ") + error.what());
  }
}
