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
    return flood->at("verdict").get<std::string>();
  const auto slides = summary.find("slides");
  return slides != summary.end() && !slides->empty() ? "slides" : "rests";
}

Decision decide(const std::string& case_name, const std::vector<SolvedInput>& solved)
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
  for (const SolvedInput& o : solved)
    if (std::ranges::find(turns, o.what) == turns.end() && std::ranges::find(holds, o.what) == holds.end())
      holds.push_back(o.what);
  const Json json = {{"terp_version", TERP_VERSION}, {"case_name", case_name}, {"outcome", base}, {"turns_on", turns},
      {"does_not_turn_on", holds}, {"runs", runs}};
  const auto list = [](const std::vector<std::string>& names) {
    return names.empty() ? std::string("nothing that was changed") : fmt::format("{}", fmt::join(names, ", "));
  };
  return {json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n",
      fmt::format("{}\nturns on: {}\n", text, list(turns))};
}

}  // namespace terp
