#include "math/checksum.hpp"
#include "io/case/case_file.hpp"
#include "io/case/case_record.hpp"
#include "io/case/key_text.hpp"
#include "io/case/samples.hpp"
#include "os/instructions.hpp"
#include "model/meshes/setup_mesh.hpp"
#include "support/paths.hpp"
#include "support/simulations.hpp"

namespace method_keys_test {

MethodOptions options_of(const std::string& method, const std::vector<std::string>& changes = {})
{
  return read_case_text(small_case + "[method]\n" + method, "case.toml", changes).values.method;
}

std::vector<std::string> texts_of(MethodOptions options)
{
  Case c;
  c.method = options;
  std::vector<std::string> texts;
  each_option(options, [&](const char* name, const auto&) {
    const KeyInfo* key = find_key(std::string("method.") + name);
    texts.push_back(std::string(name) + " = " + (key == nullptr ? "?" : value_text(*key, key->field(c, 0))));
  });
  return texts;
}

TEST(MethodKeys, AreThoseOfEachOptionAndTheWordForAll)
{
  std::vector<std::string> names = {"as"};
  MethodOptions options;
  each_option(options, [&](const char* name, const auto&) { names.emplace_back(name); });
  EXPECT_THAT(names_in_section("method"), testing::UnorderedElementsAreArray(names));
}

TEST(MethodKeys, OneWordGivesTheOptionsOfThePaper)
{
  const std::string by_name =
      "shares = \"point\"\nstrain_shares = \"plain\"\nvolume_change = \"centre\"\n"
      "pressure = \"constant\"\ncut_cells = \"mean\"\nflip = 1.0\n";
  EXPECT_EQ(texts_of(options_of("as = \"paper\"\n")), texts_of(options_of(by_name)));
  EXPECT_EQ(texts_of(options_of("", {"method.as=paper"})), texts_of(options_of(by_name)));
  EXPECT_EQ(texts_of(options_of("as = \"terp\"\n")), texts_of(MethodOptions{}));
}

TEST(MethodKeys, AnOptionBesideTheWordCounts)
{
  for (const char* method : {"as = \"paper\"\nshares = \"overlap\"\n", "shares = \"overlap\"\nas = \"paper\"\n"}) {
    MethodOptions expected = paper_options();
    expected.shares = Shares::overlap;
    EXPECT_EQ(texts_of(options_of(method)), texts_of(expected));
    expected.flip = 0.5;
    EXPECT_EQ(texts_of(options_of(method, {"method.flip=0.5"})), texts_of(expected));
    EXPECT_EQ(texts_of(options_of(method, {"method.as=terp"})).front(), "shares = \"overlap\"");
  }
}

TEST(MethodKeys, ARunThatGoesOnLooksAtTheOptionsAndNotAtTheWord)
{
  const auto record_of = [](const std::string& method) {
    const CaseFile file = read_case_text(small_case + "[method]\n" + method, "case.toml");
    return make_case_record(file, build_mesh(file.values));
  };
  const std::string all =
      "shares = \"point\"\nstrain_shares = \"plain\"\nvolume_change = \"centre\"\n"
      "pressure = \"constant\"\ncut_cells = \"mean\"\nflip = 1.0\n";
  const std::string paper = record_text(record_of("as = \"paper\""));
  EXPECT_THAT(changes_since(paper, record_of(all)), IsEmpty());
  const auto changes = changes_since(paper, record_of("as = \"paper\"\nshares = \"overlap\""));
  ASSERT_EQ(changes.size(), 1u);
  EXPECT_EQ(changes[0].text(), "method.shares (\"point\", now \"overlap\")");
}

/// Of places, velocities, stresses, strains, volumes and plastic strains, in the order of ids.
std::string digits_of_points(const State& state)
{
  Fnv1a hash;
  const auto add = [&](const auto& values) { hash.add(std::data(values), std::size(values) * sizeof(Real)); };
  for (const Point& point : points_by_id(state)) {
    add(point.x), add(point.v), add(point.sigma), add(point.strain);
    add(std::array{point.volume, point.eps_eq_p()});
  }
  return hash.digits();
}

/// The numbers are those of commit e7556d06, the last before strain shares, volume change and pressure were options.
TEST(MethodKeys, ThePapersFormHasTheBitsThatItAlwaysHad)
{
  if (instructions() == "sse2" || instructions() == "plain") GTEST_SKIP() << "without fused products bits are others";
  for (const auto& [scheme, digits] : {std::pair{"mpm_gp", "91115e2337a66f7e"}, {"mpm_mixed", "1c163c5d3a30d598"}}) {
    const CaseFile file = read_case(
        source_path("cases/column_collapse/model_2.toml"), {std::string("scheme=") + scheme, "mesh.cell=0.2"});
    Simulation s(file.values);
    s.step(200);  // to 0.24 s: soil yields and comes to other cells
    EXPECT_EQ(digits_of_points(s.state), digits) << scheme;
  }
}

}  // namespace method_keys_test
