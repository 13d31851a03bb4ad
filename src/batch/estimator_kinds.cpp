// What an estimator takes and refuses stands in its row of the table; the checks and their messages read the rows. The
// checks rely on a file whose keys are all known: a key that an estimator does not take belongs to another one. Rules
// that look beyond a key, as those of the adaptive methods and of pairs, are code of their own.

#include "batch/estimator_kinds.hpp"

#include "batch/reliability.hpp"
#include "batch/study_file.hpp"
#include "batch/study_keys.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace terp {
namespace {

using Names = std::vector<std::string>;

constexpr const char* of_points =
    "The bounds are those of independent realisations. Points that fill the space evenly are usually better, never "
    "known to be: no bound is proven for them.";
constexpr const char* of_independent = "a fragility curve needs independent samples";

Names names_of_estimators()
{
  Names names;
  for (const EstimatorInfo& info : all_estimators()) names.emplace_back(info.name);
  return names;
}

/// "`kind = "form"`, "subset" or ...": those that take a key of [estimator].
std::string kinds_with(std::string_view key)
{
  Names kinds;
  for (const EstimatorInfo& info : all_estimators())
    if (std::ranges::find(info.keys, key) != info.keys.end()) kinds.push_back(fmt::format("\"{}\"", info.name));
  std::string text = "`kind = " + kinds.front() + '`';
  for (std::size_t k = 1; k < kinds.size(); ++k) text += (k + 1 == kinds.size() ? " or " : ", ") + kinds[k];
  return text;
}

template <class Fail>
void check_keys(const StudySettings& s, const Fail& fail)
{
  const EstimatorInfo& info = info_of(s.estimator);
  static const Node none{};
  const Node* given = find_item(s.source.root, "estimator");
  const Node& table = given != nullptr ? *given : none;
  for (const Node& item : table.items)
    if (item.name != "kind" && std::ranges::find(info.keys, item.name) == info.keys.end())
      fail(join_path("estimator", item.name), fmt::format("`{}` is of {}", item.name, kinds_with(item.name)),
          "Leave it out, or choose that kind.");
  for (const NeededKey& needed : info.needs)
    if (find_item(table, needed.name) == nullptr)
      fail("estimator", fmt::format("`{}` needs `{}`", info.name, needed.name), std::string(needed.why));
  if (s.fragility && !info.no_curve.empty())
    fail("fragility", std::string(info.no_curve), "Choose monte_carlo, or leave it out.");
}

template <class Fail>
void check_adaptive(const StudySettings& s, const Fail& fail)
{
  const EstimatorInfo& info = info_of(s.estimator);
  const Index least = s.estimator == Estimator::form     ? 1
                      : s.estimator == Estimator::subset ? std::max(fewest_samples, fewest_blocks * s.adaptive.block)
                                                         : fewest_samples;
  if (s.stop.number > 0 && s.stop.number < least)
    fail("stop.number", fmt::format("`{}` takes {} realisations or more", info.name, least),
        fmt::format("Fewer say nothing of their own spread.{}",
            s.estimator == Estimator::subset ? " Each level needs ten blocks (`block`)." : ""));
  if (!s.fields.empty())
    fail(s.fields.front().path, fmt::format("`{}` draws no fields", info.name),
        "Its space is that of the random numbers. Choose monte_carlo or two_stage, or give [[random]] alone.");
}

}  // namespace

const std::vector<EstimatorInfo>& all_estimators()
{
  using enum Estimator;
  static const std::vector<EstimatorInfo> all = {
      {.kind = monte_carlo, .name = "monte_carlo", .title = "Monte Carlo", .takes_cov = true, .counts_alike = true},
      {.kind = latin_hypercube,
          .name = "latin_hypercube",
          .title = "Latin hypercube",
          .counts_alike = true,
          .remark = of_points},
      {.kind = sobol, .name = "sobol", .title = "Sobol points", .counts_alike = true, .remark = of_points},
      {.kind = two_stage,
          .name = "two_stage",
          .title = "two stages",
          .keys = {"factor", "audit"},
          .needs = {{"factor",
              "What stands with strengths divided by it is not run, but for the audit. As in factor = 1.2."}},
          .no_curve = "a fragility curve is not found in two stages",
          .inputs_go_with = "falling at the factor"},
      {.kind = multilevel,
          .name = "multilevel",
          .title = "coarse realisations, corrected by pairs",
          .keys = {"coarse", "pairs"},
          .needs = {{"coarse", "Changes of the case that make it cheap. As in coarse = { \"mesh.cell\" = 2.0 }."},
              {"pairs", "How many samples are solved with the case too, beside the coarse one. As in pairs = 40."}},
          .inputs_go_with = "a coarse slide"},
      {.kind = form,
          .name = "form",
          .title = "FORM",
          .adaptive = true,
          .remark = "FORM takes the limit state for a plane at the design point: no bound is known, and a second "
                    "design point is not seen.",
          .keys = {"event", "block"},
          .no_curve = of_independent},
      {.kind = importance_sampling,
          .name = "importance_sampling",
          .title = "importance sampling",
          .takes_cov = true,
          .adaptive = true,
          .remark = "The bounds are those of a lognormal distribution, for many places, and not proven. The samples "
                    "lie about one design point: a second one far from it is hardly seen.",
          .keys = {"event", "block"},
          .no_curve = of_independent},
      {.kind = subset,
          .name = "subset",
          .title = "subset simulation",
          .adaptive = true,
          .remark = "The bounds are those of a lognormal distribution, and not proven. The method takes its chains for "
                    "less correlated than they are, the more so the more variables: in 100 of them the true spread was "
                    "1.3 times the one that is shown, in 2 it was as shown.",
          .keys = {"event", "block"},
          .no_curve = of_independent},
      {.kind = sweep,
          .name = "sweep",
          .title = "a sweep",
          .keys = {"form"},
          .no_curve = "a sweep has no fragility curve"},
  };
  return all;
}

std::vector<StudyKey> keys_of_estimators(StudySettings& s)
{
  static const Names forms = {"grid", "table"}, events = {"slide", "flood"};
  const WordField estimator{[] { return 0; }, [&s](int k) { s.estimator = static_cast<Estimator>(k); }},
      form{[] { return 0; }, [&s](int k) { s.form = static_cast<SweepForm>(k); }},
      event{[] { return 0; }, [&s](int k) { s.adaptive.of_flood = k == 1; }};
  constexpr Real most = 1e9;
  return {{"kind", "", any_number, true, estimator, names_of_estimators},
      {"form", "", any_number, false, form, [] { return forms; }},
      {"event", "", any_number, false, event, [] { return events; }},
      {"block", "-", {1.0, 10000.0}, false, &s.adaptive.block},
      {"factor", "-", between(1.0, 10.0), false, &s.two_stage.factor},
      {"audit", "-", between(0.001, 1.0), false, &s.two_stage.audit},
      {"pairs", "-", {1.0, most}, false, &s.multilevel.pairs}};
}

void check_estimator(const StudySettings& s, std::vector<Problem>& problems)
{
  const auto fail = [&](const std::string& at, std::string what, std::string detail) {
    problems.push_back({at, std::move(what), std::move(detail), ""});
  };
  check_keys(s, fail);
  if (info_of(s.estimator).adaptive) check_adaptive(s, fail);
  if (s.stop.number > 0 && s.multilevel.pairs > s.stop.number)
    fail("estimator.pairs", "there are more pairs than realisations",
        fmt::format("Got {}, and `number` is {}. A pair is one of these samples, solved with the case too. Take a part "
                    "of them: with as many, Monte Carlo without the coarse case is cheaper.",
            s.multilevel.pairs, s.stop.number));
}

std::string plan_of_estimator(const StudySettings& s)
{
  if (s.estimator == Estimator::two_stage)
    return fmt::format("run in full: what does not stand at a factor of {:g}, and {:g} of the others",
        s.two_stage.factor, s.two_stage.audit);
  if (s.estimator == Estimator::multilevel)
    return fmt::format("{} coarse, of which the first {} are solved fine too{}", s.stop.number, s.multilevel.pairs,
        s.fragility ? ", at each level of the load" : "");
  return "";
}

}  // namespace terp
