// One table of entries writes a quantity and states the meaning of each key, so that neither can be forgotten for a new
// key. An observed order is written even where it is not usable; a limit and an error that rest on it are null then.

#include "io/results/mesh_study.hpp"

#include <cmath>

#include <nlohmann/json.hpp>

namespace terp {
namespace {

using Json = nlohmann::ordered_json;

constexpr int study_format = 1;

/// A number that is not finite becomes null when it is written.
Json or_null(std::optional<Real> value) { return value ? Json(*value) : Json(nullptr); }
Json or_null(bool is_there, Real value) { return is_there ? Json(value) : Json(nullptr); }

const char* word(Trend trend)
{
  constexpr const char* words[] = {"unknown", "unchanged", "monotone", "diverging", "oscillating"};
  return words[static_cast<int>(trend)];
}
Json value_of(const RunMeasure& measure, std::optional<Real> value)
{
  return value && measure.kind == MeasureKind::word ? Json(text_of(measure, value)) : or_null(value);
}

struct JsonKey {
  QuantityInfo info;
  Json (*read)(const StudyQuantity&);
};

using Q = const StudyQuantity&;

/// A new key is one entry here.
const JsonKey entries[] = {
    {{"name", "", "", "what it is: `front_x`, `slide_1_begins`, ..."}, [](Q q) { return Json(q.measure.name); }},
    {{"label", "", "", "in words"}, [](Q q) { return Json(q.measure.label); }},
    {{"unit", "", "", "of values, `change`, `resolution`, `limit` and `error`"},
        [](Q q) { return Json(q.measure.unit); }},
    {{"digits", "", "", "after the point, with which values are printed"},
        [](Q q) { return Json(digits_for(q.measure, q.values)); }},
    {{"values", "unit", "", "list, one for each of `runs`; `null`: not solved, or the run has none. Of some a word"},
        [](Q q) {
          Json values = Json::array();
          for (const auto& value : q.values) values.push_back(value_of(q.measure, value));
          return values;
        }},
    {{"answer", "", "",
         "`same`: equal at all sizes; `settled`: within the tolerance; `unresolved`: within the resolution; `tends`: "
         "changes by more, towards a limit; `depends`: changes by more; `some_sizes`: some sizes have it and others "
         "not; `none`: too few sizes"},
        [](Q q) { return Json(info_of(q.answer).key); }},
    {{"sentence", "", "", "the same in words"}, [](Q q) { return Json(sentence_on(q)); }},
    {{"change", "unit", "", "finest value less the one before"}, [](Q q) { return or_null(q.change); }},
    {{"relative_change", "-", "",
         "its size as a share of the finest value; of a place, of its distance since t = 0, at least one cell"},
        [](Q q) { return or_null(q.relative_change()); }},
    {{"resolution", "unit", "", "a smaller difference cannot be told from none"},
        [](Q q) { return Json(q.resolution); }},
    {{"trend", "", "", "of the three finest: `monotone`, `oscillating`, `diverging`, `unchanged`, `unknown`"},
        [](Q q) { return Json(word(q.estimate.trend)); }},
    {{"order", "-", "", "observed order p, where the trend is `monotone`; usable or not"},
        [](Q q) { return or_null(std::isfinite(q.estimate.order), q.estimate.order); }},
    {{"order_is_usable", "", "", "p lies between 1/2 and 2, and the steps can be told from none"},
        [](Q q) { return Json(q.has_order); }},
    {{"limit", "unit", "", "extrapolated to the limit of small cells; `null` without a usable order"},
        [](Q q) { return or_null(q.has_order, q.estimate.limit); }},
    {{"error", "unit", "",
         "of the finest value: grid convergence index, as a difference; `null` without a usable order"},
        [](Q q) { return or_null(q.has_order, q.estimate.uncertainty); }},
    {{"relative_error", "-", "", "the same as a share, as `relative_change`"},
        [](Q q) { return or_null(q.relative_error()); }},
};

Json quantity_json(Q q)
{
  Json json;
  for (const JsonKey& entry : entries) json[std::string(entry.info.name)] = entry.read(q);
  return json;
}

Json sequence_json(const StudiedSequence& s, Real tolerance)
{
  Json runs = Json::array(), quantities = Json::array();
  for (const StudyRun& run : s.sequence.runs)
    runs.push_back({{"cell", run.cell}, {"size", run.size}, {"folder", run.folder}, {"solved", run.fault.empty()},
        {"fault", run.fault}});
  for (const StudyQuantity& q : s.quantities) quantities.push_back(quantity_json(q));
  return {{"name", s.sequence.name}, {"changes", s.sequence.changes}, {"answer", answer_of(s, tolerance)},
      {"remarks", remarks_on(s.sequence)}, {"runs", std::move(runs)}, {"quantities", std::move(quantities)}};
}

/// The variants beside each other; `null` with one sequence.
Json spread_json(const MeshStudy& study)
{
  if (study.spreads.empty()) return nullptr;
  Json quantities = Json::array();
  for (const StudySpread& s : study.spreads) {
    Json values = Json::array();
    for (const auto& value : s.values) values.push_back(value_of(s.measure, value));
    quantities.push_back({{"name", s.measure.name}, {"label", s.measure.label}, {"unit", s.measure.unit},
        {"digits", digits_for(s.measure, s.values)}, {"values", std::move(values)}, {"range", or_null(s.range)},
        {"relative_range", or_null(s.share)}, {"matters", s.matters}});
  }
  return {{"cell", study.spread_cell}, {"answer", answer_on_variants(study)}, {"quantities", std::move(quantities)}};
}

}  // namespace

std::vector<QuantityInfo> study_keys()
{
  std::vector<QuantityInfo> keys;
  for (const JsonKey& entry : entries) keys.push_back(entry.info);
  return keys;
}

std::string study_json(const MeshStudy& study, const std::string& written)
{
  Json sequences = Json::array();
  for (const StudiedSequence& s : study.sequences) sequences.push_back(sequence_json(s, study.tolerance));
  const Json json{{"terp_version", TERP_VERSION}, {"format", study_format}, {"written", written},
      {"case_name", study.case_name}, {"title", study.title}, {"tolerance", study.tolerance},
      {"sequences", std::move(sequences)}, {"variants", spread_json(study)}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace terp
