#include "io/case/reader.hpp"
#include "io/case/case_record.hpp"
#include "io/case/render.hpp"
#include "io/case/samples.hpp"
#include "model/meshes/setup_mesh.hpp"

namespace read_stages_test {

const std::string stages = R"([[load]]
name = "traffic"
from = 1.0
to = 3.0
pressure = 0.0
[[stage]]
name = "rest"
until = "at_rest"
at_most = 9.0
set = { "forces.damping.local" = 0.4 }
[[stage]]
name = "traffic"
duration = 2.5
ramp = 0.5
set = { "load.traffic.pressure" = "13 kPa", "material.cl*.su_peak" = 6e3 }
[[stage]]
name = "weak"
duration = 1.0
reset_displacement = true
[stage.set]
forces.gravity = [0.0, -12.0]
boundary.left = "roller"
)";

Case read() { return read_case_text(replaced(small_case, "end = 4.0", "courant = 0.9") + stages, "a.toml").values; }

TEST(ReadStages, FillsTheStages)
{
  const Case c = read();
  ASSERT_EQ(c.stages.size(), 3u);
  EXPECT_EQ(c.stages[0].name, "rest");
  EXPECT_EQ(c.stages[0].until, Until::at_rest);
  EXPECT_EQ(c.stages[0].at_most, 9.0);
  EXPECT_EQ(c.stages[1].duration, 2.5);
  EXPECT_EQ(c.stages[1].ramp, 0.5);
  EXPECT_TRUE(c.stages[2].reset_displacement);
  EXPECT_FALSE(c.stages[1].reset_displacement);
  EXPECT_EQ(c.time.end, 12.5);
  EXPECT_EQ(c.stages[1].changes[0], (std::pair<std::string, std::string>("load.traffic.pressure", "\"13 kPa\"")));
}

TEST(ReadStages, TheVerdictEndsWhatSaysNoEndWhereThereIsOne)
{
  const auto until = [](const std::string& time, const std::string& more) {
    const Case c = read_case_text(replaced(small_case, "end = 4.0", time) + more, "a.toml").values;
    return std::pair(c.stages.empty() ? c.time.until : c.stages.back().until, c.time.end);
  };
  const std::string flood = "[flood]\nwater_level = 1.0\n", first = "[[stage]]\nname = \"a\"\nduration = 2.0\n",
                    last = first + "[[stage]]\nname = \"b\"\n";
  EXPECT_EQ(until("at_most = 9.0", flood), std::pair(Until::verdict, 9.0));
  EXPECT_EQ(until("end = 9.0", flood), std::pair(Until::end, 9.0));
  EXPECT_EQ(until("until = \"at_rest\"\nat_most = 9.0", flood), std::pair(Until::at_rest, 9.0));
  EXPECT_EQ(until("courant = 0.9", flood + last + "at_most = 9.0\n"), std::pair(Until::verdict, 11.0));
  EXPECT_EQ(until("courant = 0.9", flood + last + "duration = 9.0\n"), std::pair(Until::end, 11.0));
  EXPECT_EQ(until("courant = 0.9", flood + first), std::pair(Until::end, 2.0));
  EXPECT_EQ(until("courant = 0.9", last + "until = \"at_rest\"\nat_most = 9.0\n").first, Until::at_rest);
}

TEST(ReadStages, WhatAStageSetsStaysForThoseAfterIt)
{
  const Case c = read();
  EXPECT_EQ(c.forces.local_damping, 0.0);
  EXPECT_EQ(c.stages[0].changed->forces.local_damping, 0.4);
  EXPECT_EQ(c.stages[2].changed->forces.local_damping, 0.4);
  EXPECT_EQ(c.stages[0].changed->loads[0].pressure, 0.0);
  EXPECT_EQ(c.stages[1].changed->loads[0].pressure, 13e3);
  EXPECT_EQ(c.stages[2].changed->loads[0].pressure, 13e3);
  EXPECT_EQ(c.stages[0].changed->materials[0].parameters[2], 8e3);
  EXPECT_EQ(c.stages[1].changed->materials[0].parameters[2], 6e3);
  EXPECT_EQ(c.stages[2].changed->forces.gravity, (Vec<2>{0.0, -12.0}));
  ASSERT_EQ(c.stages[2].changed->sides.size(), 1u);
  EXPECT_TRUE(c.stages[1].changed->sides.empty());
  for (const StageCase& stage : c.stages) {
    EXPECT_TRUE(stage.changed->stages.empty());
    EXPECT_EQ(stage.changed->time.end, 12.5);
    EXPECT_EQ(stage.changed->name, "a");
  }
}

TEST(ReadStages, NameAnEntryOfAListByItsNumberToo)
{
  for (const char* key : {"load.0.pressure", "load[0].pressure", "load.traffic.pressure"}) {
    const std::string text = replaced(stages, "load.traffic.pressure", key);
    EXPECT_EQ(read_case_text(replaced(small_case, "end = 4.0", "courant = 0.9") + text, "a.toml")
                  .values.stages[1]
                  .changed->loads[0]
                  .pressure,
        13e3)
        << key;
  }
}

TEST(ReadStages, KnowThatTheCaseAsksAboutAFlood)
{
  const Case c = read_case_text(
      replaced(small_case, "end = 4.0", "courant = 0.9") + stages + "[flood]\nsmallest_width = 1.0\n", "a.toml")
                     .values;
  EXPECT_TRUE(c.stages[0].changed->flood.given);
  EXPECT_FALSE(read().stages[0].changed->flood.given);
}

/// All keys of the table, as the solver takes them.
TEST(ReadStages, AKeyThatIsLeftOutMeansTheSameWithoutThem)
{
  const std::string gravity = "[forces]\ngravity = [0.0, -9.81]\n", water = "[water]\nphreatic_line = [[0.0, 1.0]]\n";
  for (const std::string& sections :
      {std::string(), gravity, gravity + water, gravity + "[flood]\nsmallest_width = 1.0\n",
          gravity + "[initial]\nstress = \"k0\"\n", std::string("[method]\nas = \"paper\"\n")}) {
    CaseFile file = read_case_text(small_case + sections, "a.toml");
    CaseFile staged = read_case_text(
        replaced(small_case, "[time]\nend = 4.0\n", "[[stage]]\nname = \"all\"\nduration = 4.0\n") + sections,
        "a.toml");
    const Mesh<2> mesh = build_mesh(file.values);
    const std::string plain = record_text(make_case_record(file, mesh));
    EXPECT_EQ(staged.values.initial.stress, file.values.initial.stress) << sections;
    staged.values = *Case(staged.values).stages[0].changed;
    for (const ChangedValue& change : changes_since(plain, make_case_record(staged, mesh)))
      ADD_FAILURE() << change.text() << "\n" << sections;
  }
}

TEST(ReadStages, TheirTimesAddUpAsOneWouldWriteTheSum)
{
  const std::string three = "[[stage]]\nname = \"a\"\nduration = 0.1\n[[stage]]\nname = \"b\"\nduration = 0.2\n";
  EXPECT_EQ(read_case_text(replaced(small_case, "[time]\nend = 4.0\n", three), "a.toml").values.time.end, 0.3);
}

TEST(ReadStages, ACaseWithoutThemHasNone) { EXPECT_TRUE(read_case_text(small_case, "a.toml").values.stages.empty()); }

}  // namespace read_stages_test
