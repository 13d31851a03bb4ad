#include "import/dstability/zip_members.hpp"

#include "archives.hpp"

namespace zip_members_test {

std::string refusal_of_all(const std::string& bytes, ZipLimits limits = {})
{
  return refusal<InputError>([&] {
    ZipMembers zip("a.stix", bytes, limits);
    for (std::size_t k = 0; k < zip.names().size(); ++k) zip.text(k);
  });
}

TEST(ZipMembers, AreNamedWithSlashesAndUnpacked)
{
  ZipMembers zip(
      "a.stix", zip_of({{"states\\states_1.json", "abc"}, {"checksum", ""}, {"results/bishop//b.json", ""}}));
  EXPECT_THAT(zip.names(), ElementsAre("states/states_1.json", "checksum", "results/bishop/b.json"));
  EXPECT_EQ(zip.text(0), "abc");
  EXPECT_EQ(zip.text(1), "");
}

TEST(ZipMembers, RefuseWhatIsNoZipFile)
{
  EXPECT_THAT(refusal_of_all("PK no zip"), AllOf(StartsWith("a.stix: is no sound zip file, which a .stix file is"),
                                               HasSubstr("Save it anew in D-Stability")));
  const std::string whole = zip_of({{"a.json", std::string(5000, 'x')}});
  EXPECT_THAT(refusal_of_all(whole.substr(0, whole.size() / 2)), StartsWith("a.stix: is no sound zip file"));
}

TEST(ZipMembers, RefuseADamagedMember)
{
  std::string text;
  for (int k = 0; k < 3000; ++k) text += std::to_string(k * k);
  std::string bytes = zip_of({{"soils.json", text}});
  bytes[2000] = static_cast<char>(bytes[2000] ^ 0x55);
  EXPECT_THAT(refusal_of_all(bytes), StartsWith("a.stix, soils.json: is damaged"));
}

TEST(ZipMembers, RefuseANameThatIsThereTwice)
{
  EXPECT_THAT(refusal_of_all(zip_of({{"loads/a.json", "1"}, {"loads\\a.json", "2"}})),
      StartsWith("a.stix, loads/a.json: is there twice"));
}

TEST(ZipMembers, RefuseBombs)
{
  const std::string zeros(5'000'000, ' ');
  EXPECT_THAT(refusal_of_all(zip_of({{"a.json", zeros}})),
      AllOf(StartsWith("a.stix, a.json: unpacks to far more than text does"), HasSubstr("at most 200 times")));
  EXPECT_THAT(refusal_of_all(zip_of({{"a.json", zeros}}), {.member_bytes = 1'000'000}),
      AllOf(StartsWith("a.stix, a.json: is too large"), HasSubstr("5.0 MB unpacked, at most 1.0 MB.")));
  const Members two{{"a.json", std::string(900'000, ' ')}, {"b.json", std::string(900'000, ' ')}};
  EXPECT_THAT(refusal_of_all(zip_of(two), {.total_bytes = 1'000'000}),
      AllOf(StartsWith("a.stix, b.json: is one too many"), HasSubstr("unpacks to more than 1.0 MB.")));
  EXPECT_THAT(refusal_of_all(zip_of(two), {.members = 1}), HasSubstr("has too many members\n  2, at most 1."));
}

}  // namespace zip_members_test
