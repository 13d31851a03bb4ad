#include "import/dstability/archives.hpp"
#include "support/process.hpp"

namespace assess_doubt_test {

/// The sample with points of its embankment outside of the section.
std::string write_doubtful(const ScratchFolder& scratch)
{
  const std::string member = "waternetcreatorsettings/waternetcreatorsettings.json";
  Members members = changed(
      compact_sample(test::berm), member, "\"EmbankmentTopWaterSide\":\"NaN\"", "\"EmbankmentTopWaterSide\":-1000.0");
  members = changed(members, member, "\"EmbankmentTopLandSide\":\"NaN\"", "\"EmbankmentTopLandSide\":-900.0");
  write_file_atomically(scratch.path() + "/doubtful.stix", zip_of(members));
  return scratch.path() + "/doubtful.stix";
}

TEST(AssessDoubt, OfTheImportIsKeptWithTheSection)
{
  const ScratchFolder scratch;
  const std::string folder = scratch.path() + "/reach";
  succeeded(
      test::terp({"assess", write_doubtful(scratch), "-o", folder, "--cell", "6", "--threads", "1", "--estimate"}));
  const auto record = nlohmann::json::parse(text_of(folder + "/doubtful/section.json"));
  ASSERT_EQ(record["notes"].size(), 1u);
  EXPECT_THAT(record["notes"][0], StartsWith("The file has a point of its embankment at x = -1000.00 m, outside of"));
}

}  // namespace assess_doubt_test
