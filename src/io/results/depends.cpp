#include "io/results/depends.hpp"

#include "io/files/run_folder.hpp"
#include "io/files/summary_json.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace terp {

using Json = nlohmann::ordered_json;

std::string outcome_of_run(const std::string& folder)
{
  const Json summary = Json::parse(read_summary(path_in(folder, summary_file)).text);
  if (const auto flood = summary.find("flood");
      flood != summary.end() && flood->is_object() && flood->contains("verdict"))
    return flood->at("verdict").is_string() ? flood->at("verdict").get<std::string>() : "no verdict";
  const auto slides = summary.find("slides"), stages = summary.find("stages");
  if (slides != summary.end() && !slides->empty()) return "slides";
  if (stages == summary.end() || stages->empty()) return "no slide";
  const auto rests = [](const Json& stage) { return stage.value("at_rest", false); };
  const auto moves = [&](const Json& stage) {  // it was to end at rest and did not
    const auto speed = stage.find("fastest_node");
    return !rests(stage) && speed != stage.end() && speed->is_number();
  };
  if (std::ranges::any_of(*stages, moves)) return "still moves";
  return rests(stages->back()) ? "rests" : "no slide";
}

Decision decide(
    const std::string& case_name, const std::vector<SolvedInput>& solved, const std::vector<std::string>& not_varied)
{
  const std::string base = solved.empty() ? "" : solved.front().outcome;  // on the coarsest cells
  std::vector<std::string> turns, holds;
  Json runs = Json::array();
  std::string text;
  for (const SolvedInput& o : solved) {
    runs.push_back({{"input", o.what}, {"run", o.run}, {"outcome", o.outcome}, {"folder", o.folder}});
    text += fmt::format("  {:<24} {}{}\n", o.run, o.outcome, o.outcome == base ? "" : "  <- another outcome");
    if (o.outcome != base && std::ranges::find(turns, o.what) == turns.end()) turns.push_back(o.what);
  }
  for (const SolvedInput& o : solved)  // the first one is the case as given, which is no change
    if (&o != solved.data() && std::ranges::find(turns, o.what) == turns.end() &&
        std::ranges::find(holds, o.what) == holds.end())
      holds.push_back(o.what);
  const Json json = {{"terp_version", TERP_VERSION}, {"case_name", case_name}, {"outcome", base}, {"turns_on", turns},
      {"does_not_turn_on", holds}, {"not_varied", not_varied}, {"runs", runs}};
  const auto list = [](const std::vector<std::string>& names) {
    return names.empty() ? std::string("nothing that was changed") : fmt::format("{}", fmt::join(names, ", "));
  };
  return {json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n",
      fmt::format("{}\nturns on: {}\n{}", text, list(turns),
          not_varied.empty() ? "" : fmt::format("not varied: {}\n", fmt::join(not_varied, "; ")))};
}

}  // namespace terp
