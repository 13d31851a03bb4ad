// JSON and text are written from the same result. JSON always has all keys of the first level, with null where there is
// no value. The text states the factor first and ends with what limits it: creep, a stopped search, the size of the
// cells, a scheme that locks.

#include "io/files/stability_json.hpp"

#include "math/errors.hpp"
#include "io/files/files.hpp"
#include "mpm/schemes/scheme.hpp"
#include "run/report/slip_planes.hpp"

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
  if (s.found()) {
    if (const auto limit = r.limit())
      return fmt::format("{:.3f}   ({:.3f} to {:.3f}), {}", limit->factor, limit->low, limit->high,
          limit->is_extrapolated ? "on cells of no size" : "the lower one of two sizes of cells");
    const Real end = *s.highest();
    const std::string fails = s.failed ? fmt::format("fails at {:.3f}", end) : fmt::format("up to {:.3f}", end);
    const bool creeps = !s.failed || *s.not_stable < *s.failed;
    if (r.is_upper_bound())
      return fmt::format("at most {:.3f}   (stands at {:.3f}, {}{})", r.answer(), *s.stable,
          creeps ? fmt::format("creeps at {:.3f}, ", *s.not_stable) : "", fails);
    return fmt::format("{:.3f} +- {:.3f}   (stands at {:.3f}, {}{})", r.factor(), r.uncertainty(), *s.stable,
        creeps ? fmt::format("creeps at {:.3f}, ", *s.not_stable) : "", fails);
  }
  if (r.stopped) return "not found: stopped before";
  if (s.stable) return fmt::format("not found: the soil stands even at {:.3g}", *s.stable);
  if (s.not_stable) return fmt::format("not found: the soil does not stand even at {:.3g}", *s.not_stable);
  return "not found: nothing was tried";
}

const char* word(Facing side) { return side == Facing::right ? "right" : "left"; }

std::string place_words(Vec<2> x) { return fmt::format("({:.2f}, {:.2f}) m", x[0], x[1]); }

/// verb: what the slope does in this trial.
std::string mechanism_text(const Mechanism& mechanism, std::string_view head, std::string_view verb)
{
  std::string text = fmt::format("  {} at {:.4f}: ", head, mechanism.factor);
  if (!mechanism.moving) return text + "nothing moved in the last window\n";
  const MovingSoil& m = *mechanism.moving;
  text += fmt::format(
      "the slope on the {} of the highest ground (x = {:.2f} m) {}, its soil moves to the {}\n"
      "    enters at {}, comes out at {}, {:.2f} m deep, {:.4g} m^2\n",
      word(m.slope), m.highest_x, verb, word(m.way), place_words(m.entry), place_words(m.exit), m.depth, m.area);
  constexpr Real much = 0.05;
  if (m.other_way > much)
    text += fmt::format("    {:.0f} % of the motion goes to the other side\n", 100.0 * m.other_way);
  return text;
}

/// What failed, and what crept below it.
std::string mechanisms_text(const StabilityResult& r)
{
  std::string text;
  if (r.mechanism) text += mechanism_text(*r.mechanism, "mechanism", "fails");
  if (r.creep) text += mechanism_text(*r.creep, "creep", "creeps");
  const auto moves = r.what_moves();
  if (moves && moves->moving && !moves->moving->sand.empty() && r.options.rules.least_depth == 0.0)
    text += fmt::format(
        "    `{}` has no cohesion: where it makes the face a skin of any depth slides, and finer cells find thinner "
        "ones.\n    --least-depth D looks for the slides that are deeper\n",
        moves->moving->sand);
  return text.empty() ? text : text + "    pictures and fields: mechanism.svg, mechanism/\n";
}

std::string soil_text(const StabilityResult& r)
{
  std::string text;
  if (r.options.flow == FlowRule::associated) text += "  flow is associated: psi = phi in all soil\n";
  if (r.options.flow == FlowRule::davis)
    text += "  friction and cohesion are the reduced pair of Davis, with associated flow\n";
  if (r.options.rules.least_depth > 0.0)
    text += fmt::format("  soil less than {:g} m below the ground is not looked at\n", r.options.rules.least_depth);
  if (r.with_tension && r.sizes.size() > 1)
    text += fmt::format(
        "  soil cracks: no tension where its law sets no limit. With tension (--with-tension) it is {:.0f} % stronger "
        "on "
        "the\n  finest cells\n",
        100.0 * (r.with_tension->factor / r.factor() - 1.0));
  else if (r.with_tension)
    text += fmt::format(
        "  soil cracks: no tension where its law sets no limit. With tension (--with-tension) {:.3f} +- {:.3f}\n",
        r.with_tension->factor, r.with_tension->uncertainty);
  return text;
}

std::string numbers(const std::vector<SizedFactor>& sizes)
{
  std::string text;
  for (const SizedFactor& size : sizes)
    text += fmt::format("{}{:.3f} on cells of {:g} m", text.empty() ? "" : ", ", size.factor, size.cell);
  return text;
}

std::string order_text(const FactorLimit& limit, std::size_t n_sizes)
{
  if (!limit.is_extrapolated)
    return "Finer cells gave no less, which is no error of the mesh: nothing is extrapolated, and the lower of both "
           "brackets\n  is the answer.";
  const std::string usual =
      fmt::format("usual on slopes; the range is that of {:g} to {:g}", lowest_order, highest_order);
  const std::string found = n_sizes < 3                     ? ""
                            : std::isnan(limit.order_found) ? ".\n  The three sizes show no order"
                                                            : fmt::format(
                                                                  ".\n  The order {:.2f} that three sizes show is "
                                                                  "not used, as it is not between 1/2 and 2",
                                                                  limit.order_found);
  return fmt::format("By the order {:.2f}, {}, the limit of small cells is as above{}.", limit.order,
      limit.order_is_observed ? "observed on three sizes" : usual, limit.order_is_observed ? "" : found);
}

/// "--cells 1,0.5 measures it", with enough cells over the depth of what moves on both sizes.
std::string measure_text(const StabilityResult& r, std::string_view before)
{
  if (r.given_cell == 0.0) return "";
  Real cell = r.given_cell;
  for (Real n = r.cells_over_depth(); n < fewest_cells && n > 0.0; n *= 2.0) cell *= 0.5;
  return fmt::format("{}--cells {:.9g},{:.9g} measures it", before, cell, 0.5 * cell);
}

/// What the mechanism that decides slips along; none: no border of that kind.
std::optional<BorderUnderSlip> border_of(const StabilityResult& r)
{
  const auto moves = r.what_moves();
  return moves && moves->moving && r.search.found() ? moves->moving->border : std::nullopt;
}

Real without_row(const StabilityResult& r, const BorderUnderSlip& border)
{
  return r.factor() * (1.0 - border.share());
}

/// What a row of cells adds at the top of an aquifer, in place of the error of meshes on slopes of one soil.
std::string border_text(const StabilityResult& r, const BorderUnderSlip& border)
{
  constexpr Real little = 0.05;
  const Real factor = r.what_moves()->factor;
  return fmt::format(
      "  The mechanism follows the top of `{}` from x = {:.1f} to {:.1f} m, where water pushes from below. A row of "
      "cells of {:.3g} m\n  carries dR = {:.0f} kN/m more than that top, of R = {:.0f} kN/m in all: F (1 - dR/R) = "
      "{:.3f}. On cells of {:.2g} m dR is 5 %.\n",
      border.soil, border.from, border.to, border.row, factor * border.carried_more / 1e3,
      factor * border.strength / 1e3, without_row(r, border), border.row * std::min(little / border.share(), 1.0));
}

std::string mesh_text(const StabilityResult& r)
{
  const std::string sizes = r.sizes.size() > 1 ? fmt::format("  The mesh: {}.\n", numbers(r.sizes)) : "";
  if (const auto limit = r.limit()) return fmt::format("{}  {}\n", sizes, order_text(*limit, r.sizes.size()));
  const auto border = border_of(r);
  Real n = r.cells_over_depth(), cell = r.cell;
  if (r.is_upper_bound()) {
    for (const SizedFactor& size : r.sizes)
      if (size.cells_over_depth < n) n = size.cells_over_depth, cell = size.cell;
    return fmt::format(
               "{}  What moves is {:.1f} cells of {:.3g} m deep. So few carry far more than the soil: take the factor "
               "for an "
               "upper bound.\n  Finer cells give less{}.\n",
               sizes, n, cell, measure_text(r, "; ")) +
           (border ? border_text(r, *border) : "");
  }
  if (border)
    return "  The +- is that of the search alone. The mesh makes the factor too large.\n" + border_text(r, *border);
  return fmt::format(
      "  The +- is that of the search alone. The mesh makes the factor too large: what moves is {:.1f} cells of {:.3g} "
      "m deep,\n  and with so many it was by 0 to {:.0f} % on slopes of other authors.{}\n",
      n, cell, 100.0 * largest_mesh_error(n), r.given_cell == 0.0 ? "" : measure_text(r, " ") + ".");
}

std::string others_text(const StabilityResult& r)
{
  std::string text;
  for (const SlipPlaneCase& plane : r.slip_planes)
    if (r.search.found() && !std::isnan(plane.factor_of_safety))
      text += fmt::format(
          "    {}: this is {:+.1f} % from it\n", words_of(plane), 100.0 * (r.answer() / plane.factor_of_safety - 1.0));
  return text.empty() ? text : "  beside the factors of other methods:\n" + text;
}

Json others_json(const StabilityResult& r)
{
  Json json = Json::array();
  for (const SlipPlaneCase& plane : r.slip_planes)
    json.push_back({{"name", plane.name}, {"method", plane.method},
        {"factor_of_safety", std::isnan(plane.factor_of_safety) ? Json() : Json(plane.factor_of_safety)}});
  return json;
}

std::string notes_text(const StabilityResult& r, const std::string& scheme)
{
  std::string text;
  for (const Trial& trial : r.search.trials)
    if (trial.verdict == TrialVerdict::undecided)
      text += fmt::format(
          "  At {:.4f} the soil still crept after {} windows: it may stand or fail, and the +- has room for both. "
          "Larger\n  --windows decide it.\n",
          trial.factor, r.options.rules.most_windows);
  if (r.stopped) text += "  The search was stopped before the bracket was as narrow as asked for.\n";
  if (!r.search.found()) return text;
  if (!r.search.failed)
    text +=
        "  No trial failed, so nothing bounds the factor from above but creep: it may be far larger. Try larger "
        "--windows.\n";
  text += mesh_text(r);
  if (const Scheme* known = find_scheme(scheme); known != nullptr && known->locks) {
    std::string others;
    for (const Scheme* other : all_schemes())
      if (!other->locks) others += (others.empty() ? "" : " or ") + std::string(other->name);
    text += fmt::format("  {} locks: its factor is far too large. Use {}.\n", scheme, others);
  }
  return text;
}

Json place_json(Vec<2> x) { return {x[0], x[1]}; }

Json mechanism_json(const std::shared_ptr<const Mechanism>& mechanism)
{
  if (!mechanism || !mechanism->moving) return nullptr;
  const MovingSoil& m = *mechanism->moving;
  Json line = Json::array();
  for (const Vec<2>& x : m.line) line.push_back(place_json(x));
  return {{"factor", mechanism->factor}, {"slope", word(m.slope)}, {"moves_to", word(m.way)},
      {"highest_x", m.highest_x}, {"entry", place_json(m.entry)}, {"exit", place_json(m.exit)}, {"depth", m.depth},
      {"area", m.area}, {"sand", m.sand.empty() ? Json() : Json(m.sand)}, {"other_way", m.other_way},
      {"slip_surface", line}};
}

Json soil_json(const StabilityResult& r)
{
  constexpr const char* flows[] = {"as_given", "associated", "davis"};
  Json json = {{"cracks", r.options.cracks}, {"flow", flows[static_cast<int>(r.options.flow)]},
      {"least_depth", r.options.rules.least_depth}, {"with_tension", nullptr}};
  if (r.with_tension)
    json["with_tension"] = {{"cell", r.with_tension->cell}, {"factor", r.with_tension->factor},
        {"uncertainty", r.with_tension->uncertainty}};
  return json;
}

Json mesh_json(const StabilityResult& r)
{
  Json json = {{"cell", r.cell}, {"slope_height", r.relief}, {"cells_over_depth", r.cells_over_depth()},
      {"largest_error", nullptr}, {"border", nullptr}, {"sizes", Json::array()}, {"extrapolated", nullptr}};
  for (const SizedFactor& size : r.sizes)
    json["sizes"].push_back({{"cell", size.cell}, {"factor", size.factor}, {"uncertainty", size.uncertainty},
        {"highest", size.highest}, {"cells_over_depth", size.cells_over_depth}});
  if (const auto border = border_of(r)) {
    const Real factor = r.what_moves()->factor;
    json["border"] = {{"soil", border->soil}, {"from", border->from}, {"to", border->to}, {"row", border->row},
        {"carried_more", factor * border->carried_more}, {"strength", factor * border->strength},
        {"factor_without", without_row(r, *border)}};
  } else if (r.cells_over_depth() >= fewest_cells)
    json["largest_error"] = largest_mesh_error(r.cells_over_depth());
  if (const auto limit = r.limit())
    json["extrapolated"] = {{"factor", limit->factor}, {"low", limit->low}, {"high", limit->high},
        {"order", limit->order}, {"order_is_observed", limit->order_is_observed}, {"order_found", limit->order_found},
        {"is_extrapolated", limit->is_extrapolated}};
  return json;
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
      {"factor_of_safety", r.answer()},
      {"uncertainty", r.answer_uncertainty()},
      {"is_upper_bound", r.is_upper_bound()},
      {"stable_at", or_null(r.search.stable)},
      {"not_stable_at", or_null(r.search.not_stable)},
      {"failed_at", or_null(r.search.failed)},
      {"stopped", r.stopped},
      {"water", r.water.empty() ? Json(nullptr) : Json(r.water)},
      {"tolerance", r.options.search.tolerance},
      {"criterion", {{"local_damping", r.options.rules.damping}, {"rest", r.options.rules.rest},
                        {"failure", r.options.rules.failure}, {"most_windows", r.options.rules.most_windows},
                        {"stiffening", r.options.rules.stiffening}, {"height", r.height},
                        {"displacement_scale", r.displacement}}},
      {"mesh", mesh_json(r)},
      {"mechanism", mechanism_json(r.mechanism)},
      {"creep", mechanism_json(r.creep)},
      {"soil", soil_json(r)},
      {"other_methods", others_json(r)},
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
  if (!r.water.empty())
    text += fmt::format("  with the water {}{}\n",
        r.water == "start" ? "of t = 0" : fmt::format("of the situation `{}`", r.water),
        r.later_water ? "; situations with a `time` are not looked at: give them as stages" : "");
  for (const Trial& trial : r.search.trials)
    text += fmt::format("  {:8.4f}  {:<9}  {}\n", trial.factor, word(trial.verdict), trial.reason);
  return text + soil_text(r) + mechanisms_text(r) + others_text(r) + notes_text(r, scheme);
}

void write_stability(
    const std::string& folder, const StabilityResult& result, const std::string& scheme, const CaseText& case_text)
{
  make_folder(folder);
  write_file_atomically(path_in(folder, "stability.json"), stability_json(result, scheme, case_text));
  write_file_atomically(path_in(folder, "stability.txt"), stability_text(result, scheme));
}

}  // namespace terp
