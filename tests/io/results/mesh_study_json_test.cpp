#include "io/results/mesh_study.hpp"
#include "io/results/runs.hpp"
#include <nlohmann/json.hpp>
#include <fmt/format.h>

namespace mesh_study_json_test {

/// Three runs of a sample on cells of 0.4, 0.2, 0.1 m; the front of the second is elsewhere, the third has no crest.
MeshStudy sample_study(const ScratchFolder& scratch)
{
  StudySequence sequence{"scheme=mpm_gp", {"scheme=mpm_gp"}, {}};
  const Real cells[] = {0.4, 0.2, 0.1}, fronts[] = {12.0, 13.0, 13.5};
  for (int k = 0; k < 3; ++k) {
    const std::string folder = fmt::format("{}/{}", scratch.path(), k);
    write_run(folder, [&](Summary& s) {
      s.front_x = fronts[k], s.run_out = 5.0;
      if (k < 2) s.crest_x = 4.0;
      s.slides = {{{.begins = 0.2 + 0.1 * k, .stops = {}, .crest_from = 8.0, .crest_to = 6.0}, {}}};
    });
    sequence.runs.push_back(
        {.cell = cells[k], .size = cells[k], .folder = std::to_string(k), .results = read_run(folder)});
  }
  MeshStudy study = study_mesh({sequence}, 0.02);
  study.case_name = "column", study.title = "A column";
  return study;
}

const nlohmann::json& quantity(const nlohmann::json& json, const std::string& name)
{
  for (const auto& q : json["sequences"][0]["quantities"])
    if (q["name"] == name) return q;
  throw std::out_of_range(name);
}

TEST(MeshStudyJson, HasRunsQuantitiesAndNullForWhatIsNotDefined)
{
  const ScratchFolder scratch;
  const auto json = nlohmann::json::parse(study_json(sample_study(scratch), "2026-01-02T03:04:05Z"));
  EXPECT_EQ(json["format"], 1);
  EXPECT_EQ(json["case_name"], "column");
  EXPECT_EQ(json["tolerance"], 0.02);
  EXPECT_EQ(json["written"], "2026-01-02T03:04:05Z");
  const auto& sequence = json["sequences"][0];
  EXPECT_EQ(sequence["changes"], (std::vector<std::string>{"scheme=mpm_gp"}));
  EXPECT_EQ(sequence["runs"][1]["cell"], 0.2);
  EXPECT_EQ(sequence["runs"][1]["solved"], true);
  const auto& front = quantity(json, "front_x");
  EXPECT_EQ(front["values"], (std::vector<Real>{12.0, 13.0, 13.5}));
  EXPECT_EQ(front["answer"], "tends");
  EXPECT_NEAR(front["order"], 1.0, 1e-9);
  EXPECT_NEAR(front["limit"], 14.0, 1e-9);
  EXPECT_NEAR(front["error"], 0.625, 1e-9);
  EXPECT_NEAR(front["relative_change"], 0.1, 1e-12);  // 0.5 m of a run-out of 5 m
  const auto& crest = quantity(json, "crest_x");
  EXPECT_EQ(crest["answer"], "some_sizes");
  EXPECT_TRUE(crest["values"][2].is_null());
  EXPECT_TRUE(crest["order"].is_null());
  EXPECT_EQ(quantity(json, "facing")["values"], (std::vector<std::string>{"right", "right", "right"}));
  EXPECT_EQ(quantity(json, "slide_1_begins")["answer"], "unresolved");  // rows of the ledger are 0.25 s apart
  EXPECT_EQ(quantity(json, "slide_1_begins")["order_is_usable"], false);
  EXPECT_THROW(quantity(json, "slide_2_begins"), std::out_of_range);  // no run has it
}

TEST(MeshStudyJson, HasTheVariantsBesideEachOther)
{
  const ScratchFolder scratch;
  const MeshStudy one = sample_study(scratch);
  EXPECT_TRUE(nlohmann::json::parse(study_json(one, ""))["variants"].is_null());
  StudySequence other = one.sequences[0].sequence;
  other.name = "mesh.turn=45", other.runs[2].results.summary.values.front_x = 13.2;
  const auto json = nlohmann::json::parse(study_json(study_mesh({one.sequences[0].sequence, other}, 0.02), ""));
  EXPECT_EQ(json["variants"]["cell"], 0.1);
  EXPECT_THAT(std::string(json["variants"]["answer"]), StartsWith("On cells of 0.1 m, as given and with 1 variant: "));
  for (const auto& q : json["variants"]["quantities"]) {
    if (q["name"] != "front_x") continue;
    EXPECT_EQ(q["values"], (std::vector<Real>{13.5, 13.2}));
    EXPECT_NEAR(q["range"], 0.3, 1e-12);
    EXPECT_NEAR(q["relative_range"], 0.06, 1e-12);  // of a run-out of 5 m
    EXPECT_EQ(q["matters"], true);
  }
}

TEST(Formats, HaveTheKeysOfAQuantityInConvergenceJson)
{
  std::string block = "| key | unit | meaning |\n|---|---|---|\n";
  for (const QuantityInfo& key : study_keys())
    block += fmt::format("| `{}` | {} | {} |\n", key.name, key.unit, key.meaning);
  EXPECT_THAT(read_file(source_path("docs/formats.md")), HasSubstr(block)) << "the table must read\n" << block;
}

}  // namespace mesh_study_json_test
