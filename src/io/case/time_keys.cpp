// [time] and [[stage]] stand together, since a run without stages and a stage end by the same words. What a stage sets
// is only collected here, as keys with the text of their values. They are read later, by reading the whole file again
// with these values in it (read_stages.cpp).

#include "io/case/document.hpp"
#include "io/case/key_table.hpp"
#include "io/case/key_text.hpp"
#include "io/case/values.hpp"

#include <fmt/format.h>

namespace terp {
namespace {

std::vector<std::string> until_words() { return {"end", "at_rest", "verdict"}; }  // in the order of Until
std::vector<std::string> rest_words() { return {"fastest", "mean"}; }             // in the order of RestBy

using Changes = std::vector<std::pair<std::string, std::string>>;

OwnForm changes_field(Changes& changes)
{
  const auto read = [&changes](const Entry& entry, Findings& findings) {
    for (const auto& [key, value] : leaves_of(entry.node)) changes.emplace_back(key, toml_value(*value));
    if (entry.node.kind == NodeKind::table) return true;
    findings.problems.push_back({entry.path, "`set` must be a table { \"KEY\" = value }",
        fmt::format("Got {}.", describe_value(entry.node)), topic_of(entry.key.path)});
    return false;
  };
  const auto text = [&changes] {
    std::string all;
    for (const auto& [key, value] : changes) all += (all.empty() ? "" : ", ") + key + " = " + value;
    return all;
  };
  return {"a table { \"KEY\" = value }", read, text};
}

}  // namespace

std::vector<KeyInfo> time_keys()
{
  return {
      {.path = "time.end",
          .field = [](Case& c, std::size_t) { return &c.time.end; },
          .unit = "s",
          .range = positive,
          .usual = {1e-3, 1e4},
          .required_for = "until = \"end\"",
          .meaning = "time at which the run ends; it starts at 0"},
      {.path = "time.until",
          .field = [](Case& c, std::size_t) { return word_field(c.time.until); },
          .words = until_words,
          .meaning =
              "at_rest: the run ends as soon as the soil is at rest; verdict: as soon as it is known what remains of "
              "the ground; left out: verdict with [flood] and without `end`, otherwise end (docs/stages.md)"},
      {.path = "time.at_most",
          .field = [](Case& c, std::size_t) { return &c.time.at_most; },
          .unit = "s",
          .range = positive,
          .usual = {1e-3, 1e4},
          .required_for = "until = \"at_rest\" or \"verdict\"",
          .meaning = "time at which a run ends that has not come to rest before"},
      {.path = "time.rest_by",
          .field = [](Case& c, std::size_t) { return word_field(c.time.rest_by); },
          .words = rest_words,
          .meaning = "which motion counts for rest: fastest, the speed of the fastest node; mean, how far soil went "
                     "in rest_time, so that soil that swings in place rests (docs/stages.md)"},
      {.path = "time.rest_speed",
          .field = [](Case& c, std::size_t) { return &c.time.rest_speed; },
          .unit = "m/s",
          .range = positive,
          .usual = {1e-5, 2e-2},
          .meaning = "the soil is at rest when all nodes with soil are slower than this; those with less than 0.05 of "
                     "the mass of a full cell do not count. With rest_by = \"mean\": when less soil than a cell holds "
                     "goes farther than this times rest_time"},
      {.path = "time.rest_time",
          .field = [](Case& c, std::size_t) { return &c.time.rest_time; },
          .unit = "s",
          .range = positive,
          .meaning = "for this long without a break, after the last ramp and the last change of loads; with until = "
                     "\"verdict\" at least this long, as a rule longer: 4 H / c_s of the soil"},
      {.path = "time.courant",
          .field = [](Case& c, std::size_t) { return &c.time.courant; },
          .range = {0.0, 1.0, true, false},
          .meaning = "share of the stable time step that is used (reading R19)",
          .equation = "dt = courant min_e(L_e) / c_p,  c_p = sqrt((K + 4G/3) / rho)"},
  };
}

std::vector<KeyInfo> stage_keys()
{
  return {
      {.path = "stage[].name",
          .field = [](Case& c, std::size_t i) { return &c.stages[i].name; },
          .required = true,
          .meaning = "its name in results, and of the file that keeps its end; letters, digits, - and _"},
      {.path = "stage[].duration",
          .field = [](Case& c, std::size_t i) { return &c.stages[i].duration; },
          .unit = "s",
          .range = positive,
          .required_for = "until = \"end\"",
          .meaning = "time that the stage takes"},
      {.path = "stage[].until",
          .field = [](Case& c, std::size_t i) { return word_field(c.stages[i].until); },
          .words = until_words,
          .meaning =
              "at_rest: the stage ends as soon as the soil is at rest; see time.rest_speed; verdict, of the last "
              "stage: as soon as it is known what remains of the ground; left out: verdict in the last stage with "
              "[flood] and without `duration`, otherwise end (docs/stages.md)"},
      {.path = "stage[].at_most",
          .field = [](Case& c, std::size_t i) { return &c.stages[i].at_most; },
          .unit = "s",
          .range = positive,
          .required_for = "until = \"at_rest\" or \"verdict\"",
          .meaning = "time that a stage takes whose soil does not come to rest before; the run says so, and goes on "
                     "with the next stage"},
      {.path = "stage[].ramp",
          .field = [](Case& c, std::size_t i) { return &c.stages[i].ramp; },
          .unit = "s",
          .range = not_negative,
          .meaning =
              "time over which gravity, loads, water and, by at_strength, strengths go from their values in the stage "
              "before to the new ones, linearly; all else changes at once"},
      {.path = "stage[].water",
          .field = [](Case& c, std::size_t i) { return &c.stages[i].water; },
          .meaning = "name of the [[water.situation]] that the water goes to over `ramp`; \"start\": that of [water]. "
                     "Left out: it stays as it is"},
      {.path = "stage[].place",
          .field = [](Case& c, std::size_t i) { return NameList{&c.stages[i].place}; },
          .meaning = "names of bodies that come in this stage: they appear where they are drawn, without stress, and "
                     "their weight grows over `ramp`; before it they are not there (docs/stages.md)"},
      {.path = "stage[].remove",
          .field = [](Case& c, std::size_t i) { return NameList{&c.stages[i].remove}; },
          .meaning =
              "names of bodies that are dug away in this stage: their weight goes over `ramp`, then their points "
              "are taken out"},
      {.path = "stage[].reset_displacement",
          .field = [](Case& c, std::size_t i) { return &c.stages[i].reset_displacement; },
          .meaning = "whether displacement and strain are zero at its start, and slides are looked for anew; plastic "
                     "strain stays"},
      {.path = "stage[].trigger",
          .field = [](Case& c, std::size_t i) { return &c.stages[i].trigger; },
          .meaning =
              "whether the stage is there to make the section fail, as by weaker soil or a higher river: from its "
              "start on the verdict says so, and says what it was before (docs/flood.md)"},
      {.path = "stage[].set",
          .field = [](Case& c, std::size_t i) { return changes_field(c.stages[i].changes); },
          .meaning = "keys of the case and the values that they have from this stage on, written as for --set: "
                     "set = { \"load.traffic.pressure\" = 13e3, \"material.clay.su_peak\" = 6e3 }. `terp explain KEY` "
                     "says whether a key may change in a stage"},
  };
}

}  // namespace terp
