#include "run/report/run_findings.hpp"

#include "math/sentence.hpp"
#include "model/parts/model.hpp"
#include "run/loop/guards.hpp"
#include "run/report/summary.hpp"

#include <cmath>

namespace terp {
namespace {

namespace said {
constexpr SentenceForm far{"more of it than a cell holds went farther than {:.2g} m within {:g} s",
    "meer ervan dan een cel bevat kwam verder dan {:.2g} m in {:g} s"};
constexpr SentenceForm not_for_long{
    "its fastest node was not slower than {:.2g} m/s for {:g} s after the last change of water and loads",
    "haar snelste knoop was na de laatste verandering van water en belasting niet {1:g} s lang trager dan {0:.2g} m/s"};
constexpr SentenceForm fast{
    "its fastest node moved with {} m/s, limit {:g} m/s", "haar snelste knoop bewoog met {} m/s, grens {:g} m/s"};
constexpr SentenceForm the_run{"The run", "De berekening"};
constexpr SentenceForm the_stage{"The stage `{}`", "Fase `{}`"};
constexpr SentenceForm no_rest{"{} ended after {:.4g} s, at t = {:.4g} s, before the soil was at rest: {}.",
    "{} eindigde na {:.4g} s, op t = {:.4g} s, voordat de grond in rust was: {}."};
constexpr SentenceForm at_the_end{"At the end", "Aan het einde"};
constexpr SentenceForm at_end_of_stage{"At the end of the stage `{}`", "Aan het einde van fase `{}`"};
constexpr SentenceForm moves{
    "{} `{}` moves with {:.2g} m/s at x = {:.1f}, y = {:.1f} m, so nothing is decided: end {} at rest, or later.",
    "{} beweegt `{}` met {:.2g} m/s bij x = {:.1f}, y = {:.1f} m, zodat niets beslist is: eindig {} in rust, of "
    "later."};
constexpr SentenceForm this_run{"the run", "de berekening"};
constexpr SentenceForm that_stage{"that stage", "die fase"};
constexpr SentenceForm near_level{
    "The ground was below the water by little, for less than 2 s, or not to the end: finer cells may decide.",
    "De grond lag weinig, minder dan 2 s of niet tot het einde onder het water: kleinere cellen kunnen beslissen."};
constexpr SentenceForm small_margin{
    "The ground that remains is only {:.2f} m higher than holds the water: finer cells may decide.",
    "De grond die blijft staan is maar {:.2f} m hoger dan nodig om het water te keren: kleinere cellen kunnen "
    "beslissen."};
constexpr SentenceForm energy{"Nothing explains {:.2g} % of the energy that came from outside.",
    "Niets verklaart {:.2g} % van de energie die van buiten kwam."};
constexpr SentenceForm water{"The water did work of {:.2g} % of the energy from outside that no water gives.",
    "Het water leverde arbeid van {:.2g} % van de energie van buiten die geen water geeft."};
constexpr SentenceForm damping{
    "Local damping took {:.2g} times the energy that its factor promises: noise brakes the soil.",
    "De lokale demping nam {:.2g} keer de energie die haar factor belooft: ruis remt de grond."};
constexpr SentenceForm length{
    "Soil came to cells of which its softening length holds {:.2g}: a slip surface takes up more energy there.",
    "Grond kwam in cellen waarvan er {:.2g} in de ontsterkingslengte passen: een glijvlak neemt daar meer energie op."};
constexpr SentenceForm strength{"A law of a library returned a strength of {:.3g} Pa, below zero.",
    "Een wet uit een bibliotheek gaf een sterkte van {:.3g} Pa, kleiner dan nul."};
constexpr SentenceForm side{"Soil came to the side `{}` of the mesh by t = {:.3g} s, which acts on it from then on.",
    "Grond bereikte op t = {1:.3g} s de rand `{0}` van het rekenrooster, die er vanaf dan op werkt."};
constexpr SentenceForm side_rose{"Soil rose at the side `{}` of the mesh by t = {:.3g} s, which holds it back.",
    "Grond kwam tot t = {1:.3g} s omhoog bij de rand `{0}` van het rekenrooster, die haar tegenhoudt."};
constexpr SentenceForm clamped{"{} points had to be put back at a wall of the mesh.",
    "{} punten moesten bij een rand van het rekenrooster worden teruggezet."};
constexpr SentenceForm left{
    "{} points left the mesh through open sides.", "{} punten verlieten het rekenrooster door open randen."};
}  // namespace said

struct Asked {
  const Model& model;
  const Summary& summary;

  /// Of a follower; 0: there is none.
  Real number(const char* name) const
  {
    const auto of = summary.numbers.find(name);
    return of == summary.numbers.end() ? 0.0 : of->second;
  }
};

using Sentences = std::vector<Sentence>;

Sentence why_not_at_rest(const TimeCase& time, Real fastest)
{
  if (time.rest_by == RestBy::mean) return filled<said::far>(time.rest_speed * time.rest_time, time.rest_time);
  if (fastest < time.rest_speed) return filled<said::not_for_long>(time.rest_speed, time.rest_time);
  const std::string limit = fmt::format("{:g}", time.rest_speed);
  std::string speed;
  for (int digits = 2; digits <= 6 && (speed.empty() || speed == limit); ++digits)
    speed = fmt::format("{:.{}g}", fastest, digits);
  return filled<said::fast>(speed, time.rest_speed);
}

/// Stages, or the run, that were to end at rest and did not; a verdict on soil that still moves.
Sentences of_rest(const Asked& asked)
{
  const Summary& s = asked.summary;
  Sentences found;
  for (const StageSummary& stage : s.stages) {
    const StageRecord& r = stage.record;
    if (!r.at_rest && std::isfinite(r.fastest))
      found.push_back(
          filled<said::no_rest>(stage.name.empty() ? filled<said::the_run>() : filled<said::the_stage>(stage.name),
              r.end - r.start, r.end, why_not_at_rest(asked.model.description.time, r.fastest)));
  }
  const bool ends_at_rest = !s.stages.empty() && std::isfinite(s.stages.back().record.fastest);
  const auto& flood = s.flood;
  if (!flood || !flood->still_moves || flood->first_time_below) return found;
  const bool at_end = flood->moves_at_end();
  if (!at_end || !ends_at_rest)
    found.push_back(
        filled<said::moves>(at_end ? filled<said::at_the_end>() : filled<said::at_end_of_stage>(flood->stage_moving),
            flood->fastest_soil, flood->fastest_node.value_or(FloodSummary::none), flood->fastest_x, flood->fastest_y,
            at_end ? filled<said::this_run>() : filled<said::that_stage>()));
  return found;
}

Sentences of_sides(const Asked& asked)
{
  Sentences found;
  for (const ReachedSide& reached : asked.summary.reached_sides)
    found.push_back(reached.rose ? filled<said::side_rose>(reached.side, reached.time)
                                 : filled<said::side>(reached.side, reached.time));
  return found;
}

Sentences if_so(bool holds, const Sentence& sentence) { return holds ? Sentences{sentence} : Sentences(); }

struct Kind {
  const char *id, *see;
  Sentences (*find)(const Asked&);
};

/// A new one is an entry here.
constexpr Kind kinds[] = {
    {"rest", "docs/stages.md#at-rest", of_rest},
    {"near", "docs/flood.md#the-verdict",
        [](const Asked& a) {
          return if_so(a.summary.flood && a.summary.flood->verdict == FloodVerdict::near, filled<said::near_level>());
        }},
    {"margin", "docs/flood.md#how-sure-is-it",
        [](const Asked& a) {
          const bool is_small = a.summary.flood && a.summary.flood->margin;
          return if_so(is_small, filled<said::small_margin>(is_small ? *a.summary.flood->margin : 0.0));
        }},
    {"energy", "docs/troubleshooting.md#the-energy-balance-is-off",
        [](const Asked& a) {
          const Real share = a.summary.unexplained_energy;
          return if_so(share > unexplained_that_warns, filled<said::energy>(100.0 * share));
        }},
    {"water", "docs/water.md#in-soil-that-moves",
        [](const Asked& a) {
          const Real share = a.number("water_from_nowhere");
          return if_so(share > unexplained_that_warns, filled<said::water>(100.0 * share));
        }},
    {"damping", "docs/troubleshooting.md#damping-took-more-than-it-promises",
        [](const Asked& a) {
          const Real times = a.number("damping_over_promised");
          return if_so(
              times > much_damping && a.number("damping_fraction") > much_damped, filled<said::damping>(times));
        }},
    {"softening_length", "docs/softening_length.md",
        [](const Asked& a) {
          // It was told of less at t = 0.
          const Real cells = a.number("softening_length_over_cell_reached");
          const bool is_new = cells < a.number("softening_length_over_cell");
          return if_so(is_new && cells < least_cells * (1.0 - 1e-9), filled<said::length>(cells));
        }},
    {"strength", "docs/user_laws.md#the-keys",
        [](const Asked& a) {
          const Real lowest = a.number("lowest_library_strength");
          return if_so(lowest < 0.0, filled<said::strength>(lowest));
        }},
    {"side", "docs/troubleshooting.md#soil-reaches-the-side-of-the-mesh", of_sides},
    {"clamped", "docs/troubleshooting.md#clamped-points",
        [](const Asked& a) {
          return if_so(a.summary.clamped_points > 0, filled<said::clamped>(a.summary.clamped_points));
        }},
    {"left", "docs/formats.md#left_the_meshcsv",
        [](const Asked& a) { return if_so(a.summary.points_left > 0, filled<said::left>(a.summary.points_left)); }},
};

}  // namespace

std::vector<RunFinding> findings_against(const Model& model, const Summary& summary)
{
  std::vector<RunFinding> findings;
  for (const Kind& kind : kinds)
    for (Sentence& text : kind.find({model, summary}))
      findings.push_back({kind.id, std::move(text.en), std::move(text.nl), kind.see});
  return findings;
}

}  // namespace terp
