#include "io/case/explain.hpp"
#include "io/case/case_file.hpp"
#include "io/case/key_text.hpp"
#include "model/meshes/structured.hpp"
#include "mpm/schemes/scheme.hpp"
#include "support/test.hpp"

namespace explain_test {

TEST(Explain, KnowsEveryKeyDottedAndByItsLastPart)
{
  for (const KeyInfo& key : all_keys()) {
    EXPECT_THAT(explain(topic_of(key.path)), HasSubstr(last_part(key.path))) << key.path;
    EXPECT_FALSE(explain(last_part(key.path)).empty()) << key.path;
  }
}

TEST(Explain, KnowsEveryLawSchemeAndSection)
{
  for (const MaterialType* law : all_materials())
    EXPECT_THAT(explain(std::string(law->name)), HasSubstr(std::string(law->summary)));
  for (const Scheme* scheme : all_schemes())
    EXPECT_THAT(explain(std::string(scheme->name)), HasSubstr(std::string(scheme->summary)));
  for (const SectionInfo& section : all_sections())
    EXPECT_THAT(explain(topic_of(section.path)), HasSubstr(section.meaning));
}

TEST(Explain, GivesTheSizesOfCellsThatAGradedMeshHas)
{
  EXPECT_THAT(explain("mesh.grading"), HasSubstr("    equation  h_k = h_1 grading^((k - 1) / (n - 1)), k = 1 to n\n"));
  constexpr Index n = 7;
  constexpr Real grading = 3.5;
  const std::vector<Real> ends = graded_shares(n, grading);
  const auto size = [&](Index k) { return ends[k] - ends[k - 1]; };
  for (Index k = 1; k <= n; ++k) EXPECT_NEAR(size(k), size(1) * std::pow(grading, (k - 1.0) / (n - 1.0)), 1e-14) << k;
}

TEST(Explain, HasAMeaningForEveryKeyAndSection)
{
  for (const KeyInfo& key : all_keys()) EXPECT_GT(key.meaning.size(), 10u) << key.path;
  for (const SectionInfo& section : all_sections()) EXPECT_GT(section.meaning.size(), 10u) << section.path;
}

TEST(Explain, KnowsTheSectionOfEveryKey)
{
  for (const KeyInfo& key : all_keys()) {
    const std::string section = key.path.substr(0, key.path.rfind('.'));
    if (section == key.path || section == "boundary.SIDE") continue;
    EXPECT_NE(find_section(section), nullptr) << key.path;
  }
}

}  // namespace explain_test
