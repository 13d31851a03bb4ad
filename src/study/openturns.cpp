// How it thinks: the event is a function of independent standard normal variables, so that OpenTURNS has nothing to
// transform. It asks for the function in blocks. Built only where CMake finds OpenTURNS (else no_openturns.cpp).

#include "study/reliability.hpp"

#include <openturns/AbdoRackwitz.hxx>
#include <openturns/CompositeRandomVector.hxx>
#include <openturns/FORM.hxx>
#include <openturns/Function.hxx>
#include <openturns/ImportanceSamplingExperiment.hxx>
#include <openturns/LessOrEqual.hxx>
#include <openturns/Log.hxx>
#include <openturns/NonCenteredFiniteDifferenceGradient.hxx>
#include <openturns/Normal.hxx>
#include <openturns/ProbabilitySimulationAlgorithm.hxx>
#include <openturns/RandomGenerator.hxx>
#include <openturns/SubsetSampling.hxx>
#include <openturns/ThresholdEvent.hxx>

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

/// The limit state as OpenTURNS asks for it.
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

template <class Algorithm>
void simulate(const ReliabilityRule& rule, Index number, Algorithm& algorithm, ReliabilityResult& result)
{
  const Index block = std::min(rule.block, number);
  algorithm.setBlockSize(static_cast<OT::UnsignedInteger>(block));
  algorithm.setMaximumOuterSampling(static_cast<OT::UnsignedInteger>(std::max<Index>(1, number / block)));
  algorithm.run();
  const auto found = algorithm.getResult();
  result.probability = found.getProbabilityEstimate();
  if (result.probability > 0.0) result.cov = found.getCoefficientOfVariation();
}

}  // namespace

bool has_openturns() { return true; }

ReliabilityResult find_probability(const ReliabilityRule& rule, const LimitState& limit)
{
  OT::Log::Show(OT::Log::NONE);
  OT::RandomGenerator::SetSeed(static_cast<OT::UnsignedInteger>(rule.seed));
  ReliabilityResult result;
  const OT::ThresholdEvent event = event_of(Evaluation(limit, rule.n_numbers, result.n_places));
  if (rule.kind == Estimator::subset) {
    OT::SubsetSampling subset(event);
    simulate(rule, rule.number, subset, result);
    return result;
  }
  find_design_point(rule, event, result);
  result.converged = std::abs(limit({result.design_point}).front()) < 0.05;
  ++result.n_places;
  if (rule.kind == Estimator::form) return result;
  OT::Point centre(result.design_point.begin(), result.design_point.end());
  OT::ProbabilitySimulationAlgorithm sampling(
      event, OT::ImportanceSamplingExperiment(OT::Normal(centre, OT::CovarianceMatrix(rule.n_numbers))));
  sampling.setMaximumCoefficientOfVariation(rule.cov);
  simulate(rule, std::max<Index>(1, rule.number - result.n_places), sampling, result);
  return result;
}

}  // namespace terp
