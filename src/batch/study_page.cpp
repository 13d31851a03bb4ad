// The page counts kinds and classes from the outcomes of all realisations. Inputs and words of a realisation are only
// there for the rows of its table, but of a sweep for all. Inputs have the order of Study::input_names(); fields are
// the last of them.

#include "batch/study_page.hpp"

#include "io/case/keys.hpp"
#include "io/case/units.hpp"
#include "batch/fragility_text.hpp"
#include "batch/study_text.hpp"
#include "page/document.hpp"

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

using Json = nlohmann::ordered_json;

constexpr Index most_rows = 500;    // of the table; results.csv has all
constexpr Index most_places = 200;  // of a line over the realisations

/// Units of inputs as they are drawn; a field is a share of its trend, a value of a sweep may be a word.
std::vector<PageColumn> input_columns(const Study& study)
{
  std::vector<PageColumn> columns;
  const std::vector<std::string> names = study.input_names();
  const std::size_t first_field = names.size() - study.settings.fields.size();
  for (std::size_t k = 0; k < names.size(); ++k) {
    const bool is_field = k >= first_field;
    const std::string unit = is_field ? "" : unit_at(names[k]);
    columns.push_back(
        {is_field ? "field" : names[k], is_field ? study.settings.fields[k - first_field].key : names[k], unit, {}});
  }
  return columns;
}

/// What is known of each realisation: state 0 solved, 1 failed, 2 not run, 3 slides as drawn.
std::vector<PageColumn> outcome_columns(const Study& study, const Realisations& rows, Index n)
{
  std::vector<PageColumn> columns{{"state", "", "-", {}}, {"slide", "", "-", {}}, {"flood", "", "-", {}},
      {"level", "", "-", {}}, {"coarse", "", "-", {}}};
  for (const OutcomeInfo& outcome : study_outcomes())
    columns.push_back(
        {std::string(outcome.info.name), std::string(outcome.info.label), std::string(outcome.info.unit), {}});
  for (Index k = 0; k < n; ++k) {
    const Realisation& r = rows.at(k);
    const bool is_known = !r.failed() && !r.skipped();
    std::vector<Real> values{r.skipped()           ? 2.0
                             : r.slides_as_drawn() ? 3.0
                             : r.failed()          ? 1.0
                                                   : 0.0,
        is_known ? Real(r.slid) : std::nan(""), r.knows_flood() ? Real(r.flooded) : std::nan(""),
        static_cast<Real>(study.level_of(k)), Real(study.is_coarse(k))};
    for (std::size_t i = 0; i < study_outcomes().size(); ++i)
      values.push_back(r.solved() ? r.outcomes[i] : std::nan(""));
    for (std::size_t c = 0; c < columns.size(); ++c) columns[c].values.push_back(values[c]);
  }
  return columns;
}

/// P and its bounds of the first n realisations, for n up to all: [n, P, low, high].
Json growth_json(const Study& study, const Realisations& rows, Index n_made, bool of_flood)
{
  Json places = Json::array();
  const Index stride = 1 + n_made / most_places;
  Sample sample(study.settings);
  for (Index k = 0; k < n_made; ++k) {
    sample.take(rows.at(k), study.is_coarse(k));
    if ((k + 1) % stride != 0 && k + 1 != n_made) continue;
    const EventEstimate e = of_flood ? sample.flood() : sample.slide();
    const auto p = e.probability();
    places.push_back({k + 1, p ? Json(*p) : Json(), e.bounds.low, e.bounds.high});
  }
  return places;
}

/// The values of each key as words, and as numbers where all of them are numbers.
Json sweep_json(const StudySettings& settings)
{
  Json keys = Json::array();
  for (const SweepKey& key : settings.sweep) {
    std::vector<Real> numbers;
    for (const Node& value : key.values)
      if (const auto number = number_of(value, unit_at(key.key))) numbers.push_back(*number);
    keys.push_back({{"key", key.key}, {"unit", unit_at(key.key)}, {"of_numbers", key.is_of_numbers()},
        {"numbers", numbers.size() == key.values.size() ? Json(numbers) : Json()}});
  }
  return keys;
}

/// Its distribution function over the levels, and beyond them where it is wider: [level, probability not exceeded].
Json load_json(const FragilityLoad& load)
{
  Json places = Json::array();
  if (load.distribution) {
    constexpr int n = 100;
    const Real low = std::min(load.levels.front(), load.distribution->quantile(0.01)),
               high = std::max(load.levels.back(), load.distribution->quantile(0.99));
    for (int k = 0; k <= n; ++k) {
      const Real h = low + (high - low) * k / n;
      places.push_back({h, load.distribution->probability(h)});
    }
  }
  return {{"name", load.name}, {"unit", load.unit}, {"levels", load.levels}, {"distribution", std::move(places)},
      {"is_water_level", is_water_level(load)}};
}

void add_table_of_realisations(const Study& study, const Realisations& rows, Index n, PageDocument& page)
{
  const Index n_shown = study.settings.estimator == Estimator::sweep ? n : std::min(n, most_rows);
  std::vector<PageColumn> inputs = input_columns(study);
  Json words = Json::array(), faults = Json::object();
  for (Index k = 0; k < n_shown; ++k) {
    const Realisation& r = rows.at(k);
    for (std::size_t i = 0; i < inputs.size(); ++i) inputs[i].values.push_back(r.inputs[i]);
    Json of_row = Json::array();
    for (const RowLabel& label : row_labels(study)) of_row.push_back(label.word(study, r));
    for (std::size_t i = 0; i < study.settings.sweep.size(); ++i) of_row.push_back(input_text(study, i, r.inputs[i]));
    words.push_back(std::move(of_row));
    if (!r.fault.empty()) faults[std::to_string(k)] = r.fault;
  }
  Json labels = Json::array();
  for (const RowLabel& label : row_labels(study)) labels.push_back(label.name);
  page.data["inputs"] = page.table(inputs);
  page.data["row_labels"] = std::move(labels);
  page.data["words"] = std::move(words);
  page.data["faults_of"] = std::move(faults);
  page.data["outcomes"] = page.table(outcome_columns(study, rows, n));
}

}  // namespace

Payload study_payload(const Study& study, const Realisations& rows, const std::string& written)
{
  PageDocument page(study_json(study, rows));
  const Index n = TableCounter(study, rows).n();
  const StudySettings& settings = study.settings;
  add_table_of_realisations(study, rows, n, page);
  page.data["sweep"] = sweep_json(settings);
  if (settings.fragility) page.data["of_load"] = load_json(*settings.fragility);
  if (!page.data["slide"].is_null() && !info_of(settings.estimator).adaptive)
    for (const bool of_flood : {false, true})
      page.data["growth"][of_flood ? "flood" : "slide"] = growth_json(study, rows, n, of_flood);
  return page.payload("study", written);
}

Payload samples_payload(const Study& study, Index n, const std::string& written)
{
  constexpr int most = 90;  // values along a side of a picture
  constexpr Index n_pictures = 4;
  std::vector<PageColumn> inputs = input_columns(study);
  for (Index k = 0; k < n; ++k) {
    const Draw draw = draw_realisation(study, study.first_of_turn(k * study.n_levels()));
    for (std::size_t i = 0; i < inputs.size(); ++i) inputs[i].values.push_back(draw.inputs[i]);
  }
  const StudySettings& settings = study.settings;
  PageDocument page("{}");
  page.data = {{"title", settings.title.empty() ? settings.name : settings.title}, {"case", settings.case_path},
      {"samples", n}, {"inputs", page.table(inputs)}, {"fields", Json::array()}};
  for (std::size_t f = 0; f < settings.fields.size(); ++f) {
    const auto& [low, high] = study.boxes[f];
    const Vec<2> size{high[0] - low[0], high[1] - low[1]};
    const int ny = std::clamp(static_cast<int>(most * size[1] / size[0]), 12, most);
    std::vector<PageColumn> pictures;  // values over the trend, by rows from above
    for (Index r = 0; r < std::min(n, n_pictures); ++r) {
      const FieldOverTrend over(study, f, r);
      pictures.push_back({std::to_string(r), "", "-", {}});
      for (int j = 0; j < ny; ++j)
        for (int i = 0; i < most; ++i)
          pictures.back().values.push_back(
              over.at({low[0] + (i + 0.5) / most * size[0], high[1] - (j + 0.5) / ny * size[1]}));
    }
    page.data["fields"].push_back({{"key", settings.fields[f].key}, {"across", most}, {"box", study.boxes[f]},
        {"pictures", page.table(pictures)}});
  }
  return page.payload("study", written);
}

}  // namespace terp
