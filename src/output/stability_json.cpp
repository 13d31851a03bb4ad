#include "output/stability_json.hpp"

#include "base/errors.hpp"
#include "output/files.hpp"
#include "schemes/scheme.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace terp {
namespace {

using Json = nlohmann::ordered_json;

Json or_null(const std::optional<Real>& value) { return value ? Json(*value) : Json(nullptr); }

const char* word(TrialVerdict verdict)
{
  switch (verdict) {
    case TrialVerdict::stable: return "stable";
    case TrialVerdict::failed: return "failed";
    case TrialVerdict::undecided: break;
  }
  return "undecided";
}

Json trial_json(const Trial& trial)
{
  Json time = Json::array(), displacement = Json::array(), out_of_balance = Json::array();
  for (const TrialWindow& w : trial.windows) {
    time.push_back(w.time);
    displacement.push_back(w.displacement);
    out_of_balance.push_back(w.out_of_balance);
  }
  return {{"factor", trial.factor}, {"verdict", word(trial.verdict)}, {"reason", trial.reason}, {"steps", trial.steps},
      {"wall_s", trial.wall_s}, {"time", time}, {"displacement", displacement}, {"out_of_balance", out_of_balance}};
}

std::string bracket_text(const StabilityResult& r)
{
  const Bisection& s = r.search;
  if (s.found())
    return fmt::format("{:.3f} +- {:.3f}   (stands at {:.3f}, does not at {:.3f})", r.factor(),
        0.5 * (*s.failed - *s.stable), *s.stable, *s.failed);
  if (r.stopped) return "not found: stopped before";
  if (s.stable) return fmt::format("not found: the soil stands even at {:.3g}", *s.stable);
  if (s.failed) return fmt::format("not found: the soil does not stand even at {:.3g}", *s.failed);
  return "not found: nothing was tried";
}

/// What the bracket does not say.
std::string notes_text(const StabilityResult& r, const std::string& scheme)
{
  std::string text;
  for (const Trial& trial : r.search.trials)
    if (trial.verdict == TrialVerdict::undecided)
      text += fmt::format(
          "  At {:.4f} the soil still crept after {} windows; that counts as not standing. Larger --windows decide "
          "it.\n",
          trial.factor, r.options.rules.most_windows);
  if (r.stopped) text += "  The search was stopped before the bracket was as narrow as asked for.\n";
  if (!r.search.found()) return text;
  if (std::ranges::none_of(r.search.trials, [](const Trial& t) { return t.verdict == TrialVerdict::failed; }))
    text +=
        "  No trial failed, so nothing bounds the factor from above but creep: it may be far larger. Try larger "
        "--windows.\n";
  text +=
      "  The width is that of the search alone; the mesh makes the factor too large. Halve the cells and compare "
      "(docs/stability.md).\n";
  if (const Scheme* known = find_scheme(scheme); known != nullptr && known->locks) {
    std::string others;
    for (const Scheme* other : all_schemes())
      if (!other->locks) others += (others.empty() ? "" : " or ") + std::string(other->name);
    text += fmt::format("  {} locks: its factor is far too large. Use {}.\n", scheme, others);
  }
  return text;
}

}  // namespace

std::string stability_json(const StabilityResult& r, const std::string& scheme, const CaseText& case_text)
{
  Json strengths = Json::array(), trials = Json::array();
  for (const Strength& s : r.strengths) strengths.push_back({{"key", s.key}, {"unit", s.unit}, {"value", s.value}});
  for (const Trial& trial : r.search.trials) trials.push_back(trial_json(trial));
  const Json json = {
      {"terp_version", TERP_VERSION},
      {"scheme", scheme},
      {"points", r.n_points},
      {"factor_of_safety", r.factor()},
      {"stable_at", or_null(r.search.stable)},
      {"not_stable_at", or_null(r.search.failed)},
      {"stopped", r.stopped},
      {"tolerance", r.options.search.tolerance},
      {"criterion", {{"local_damping", r.options.rules.damping}, {"rest", r.options.rules.rest},
                        {"failure", r.options.rules.failure}, {"most_windows", r.options.rules.most_windows},
                        {"stiffening", r.options.rules.stiffening}, {"height", r.height},
                        {"displacement_scale", r.displacement}}},
      {"strengths", strengths},
      {"rest_steps", r.rest_steps},
      {"trials", trials},
      {"case_name", case_text.name},
      {"case", case_text.toml},
  };
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string stability_text(const StabilityResult& r, const std::string& scheme)
{
  std::string text = fmt::format("factor of safety {}\n", bracket_text(r));
  text += fmt::format("  by reduction of {} strength{}, {}, {} points, local damping {:g}\n", r.strengths.size(),
      r.strengths.size() == 1 ? "" : "s", scheme, r.n_points, r.options.rules.damping);
  text += fmt::format(
      "  stands: moves as if below {:.1e} of its weight were out of balance; fails: moved {:g} rho g H^2/E = {:.3g} m "
      "and does not slow down\n",
      r.options.rules.rest, r.options.rules.failure, r.options.rules.failure * r.displacement);
  for (const Trial& trial : r.search.trials)
    text += fmt::format("  {:8.4f}  {:<9}  {}\n", trial.factor, word(trial.verdict), trial.reason);
  return text + notes_text(r, scheme);
}

void write_stability(
    const std::string& folder, const StabilityResult& result, const std::string& scheme, const CaseText& case_text)
{
  make_folder(folder);
  write_file_atomically(path_in(folder, "stability.json"), stability_json(result, scheme, case_text));
  write_file_atomically(path_in(folder, "stability.txt"), stability_text(result, scheme));
}

}  // namespace terp
