#include "import/drawing/ground_profile.hpp"
#include "math/errors.hpp"
#include "support/test.hpp"

namespace ground_profile_test {

DxfRegions profile(const std::string& text, ProfileOptions options = {})
{
  options.base = options.base.value_or(-6.0);
  return read_profile("p.csv", text, options);
}

Real area(const std::string& text, const ProfileOptions& options = {})
{
  return signed_area(profile(text, options).regions.at(0).polygon);
}

// 60 m from -6 m to -1 m, the dike above -1 m: 53 + 4.6 m^2 up to the ditch, less its corner.
constexpr Real whole = 368.8;

TEST(GroundProfile, IsOneSoilAboveItsBase)
{
  const std::string rows = "0,-1.0\n12,-1.0\n22,3.5\n26,3.5\n38,-0.5\n40,-1.2\n60,-1.0\n";
  EXPECT_NEAR(area("l,z\n" + rows), whole, 1e-9);
  EXPECT_NEAR(area(rows), whole, 1e-9);
  EXPECT_NEAR(area("# surveyed\nz;afstand\n-1,0;0\n-1,0;12\n3,5;22\n3,5;26\n-0,5;38\n-1,2;40\n-1,0;60\n"), whole, 1e-9);
  EXPECT_NEAR(area("x,z\n60,-1.0\n40,-1.2\n38,-0.5\n26,3.5\n22,3.5\n12,-1.0\n0,-1.0\n"), whole, 1e-9);
  EXPECT_NEAR(area("distance [mm];level [mm]\n0;-1000\n12000;-1000\n22000;3500\n26000;3500\n38000;-500\n40000;-1200\n"
                   "60000;-1000\n"),
      whole, 1e-9);
  const DxfRegions gaps = profile("l,z\n0,-1\n5,NaN\n10,-1\n10,0\n20,0\n");
  EXPECT_NEAR(signed_area(gaps.regions[0].polygon), 110.0, 1e-9);
  EXPECT_THAT(gaps.notes, Contains("1 rows without numbers were left out."));
}

TEST(GroundProfile, MayHaveAnEmptyFirstCell) { EXPECT_NEAR(area("remark\tl\tz\n\t0\t0\n\t10\t0\n"), 60.0, 1e-9); }

TEST(GroundProfile, OfSeveralIsChosenByItsName)
{
  const std::string table = "name,l,z\nA,0,0\nA,10,0\nB,0,1\nB,20,1\n";
  EXPECT_NEAR(area(table, {.name = "B"}), 140.0, 1e-9);
  EXPECT_THAT(refusal<InputError>([&] { profile(table); }), HasSubstr("holds 2 profiles"));
  EXPECT_THAT(refusal<InputError>([&] { profile(table, {.name = "C"}); }), HasSubstr("has no profile `C`"));
}

TEST(GroundProfile, ThatGoesBackOrIsNoneIsRefused)
{
  EXPECT_THAT(refusal<InputError>([] { profile("l,z\n0,0\n10,0\n5,1\n20,0\n"); }), HasSubstr("goes back"));
  EXPECT_THAT(refusal<InputError>([] { profile("l,z\nno,numbers\n"); }), HasSubstr("is no ground profile"));
  EXPECT_THAT(refusal<InputError>([] { profile("l,z\n0,-7\n10,0\n"); }), HasSubstr("has ground below the base"));
  EXPECT_NEAR(read_profile("p.csv", "0,1\n10,1\n", {.depth = 4.0}).regions[0].polygon.back()[1], -3.0, 1e-12);
}

TEST(GroundProfile, ThatCouldMeanSomethingElseIsRefused)
{
  const auto refused = [](const std::string& text, const std::string& name = "") {
    return refusal<InputError>([&] { profile(text, {.name = name}); });
  };
  EXPECT_THAT(refused("afstand;diepte\n0;1\n10;2\n"), HasSubstr("has depths, and no levels"));
  EXPECT_THAT(refused("x,z\n0,0\n30,5,25\n"), HasSubstr("has rows of more cells than others"));
  EXPECT_THAT(refused("1 0 2\n2 10 3\n"), HasSubstr("does not say which columns"));
  EXPECT_THAT(refused("LOCATIONID;X1;Y1;Z1\nA;0;0;0;20;0;0;18;0;3;50;0;0\n", "A"), HasSubstr("goes back in `A`"));
  EXPECT_THAT(refused("LOCATIONID;X1;Y1;Z1\nA;0;0;0;20;0;0;40;0\n", "A"), HasSubstr("without x, y or z in `A`"));
  EXPECT_NEAR(area("x;z;\n0;\xE2\x88\x92"
                   "1;\n10;\xE2\x88\x92"
                   "1;\n",
                  {.base = -2.0}),
      10.0, 1e-9);
  EXPECT_NEAR(area("easting,northing,elevation\n3,4,0\n6,8,0\n", {.base = -2.0}), 10.0, 1e-9);
  EXPECT_THAT(profile("l,z\n0,0\n5,1o\n10,0\n").doubts, ElementsAre(HasSubstr("1 rows without numbers")));
}

TEST(GroundProfile, OfSeveralWithoutANameIsRefused)
{
  const auto refused = [](const std::string& text) { return refusal<InputError>([&] { profile(text); }); };
  EXPECT_THAT(refused("afstand;z;hoogte\n0;0;1\n10;0;1\n"), HasSubstr("levels or distances: z, hoogte"));
  EXPECT_THAT(refused("l;z_2019 [m];z_2023 [m]\n0;0;1\n10;0;1\n"), HasSubstr("z_2019 [m], z_2023 [m]"));
  EXPECT_THAT(refused("l;afstand;z\n0;0;1\n10;0;1\n"), HasSubstr("l, afstand"));
  EXPECT_THAT(refused("vak;l;z\nA;0;0\nA;10;0\nB;0;1\nB;10;1\n"), HasSubstr("name them in a column `profile`"));
  EXPECT_THAT(refused("l,z\n0,0\n0,1\n5,0\n5,1\n10,0\n10,1\n15,0\n15,1\n"), HasSubstr("two levels at 4 places"));
  EXPECT_NEAR(area("l,z\n0,0\n5,0\n5,1\n9,1\n9,2\n12,2\n12,3\n15,3\n15,4\n20,4\n"), 120.0 + 4 + 6 + 9 + 20, 1e-9);
}

TEST(GroundProfile, HasTheUnitOfItsHeads)
{
  EXPECT_NEAR(area("l [km];z_ft\n0;0\n0,01;10\n", {.base = -1.0}), 10.0 * (1.0 + 0.5 * 3.048), 1e-9);
  EXPECT_NEAR(area("dist_to_river,level_mNAP\n0,0\n10,0\n", {.base = -1.0}), 10.0, 1e-9);
  EXPECT_NEAR(area("Distance (m);Level [m NAP]\n0;0\n10;0\n", {.base = -1.0}), 10.0, 1e-9);
  EXPECT_THAT(refusal<InputError>([] { profile("l [furlong],z\n0,0\n10,0\n"); }), HasSubstr("does not know, `l [fur"));
  EXPECT_THAT(profile("l,z\n0,0\n1000,900\n").doubts, ElementsAre(HasSubstr("1000 m wide and 900 m high")));
}

TEST(GroundProfile, IsALineOfSurfacelines)
{
  const std::string table =
      "LOCATIONID;X1;Y1;Z1;.....;Xn;Yn;Zn;(Profiel)\ndp_1;3;4;0;6;8;2;6;18;0;\ndp_2;0;0;1;10;0;1\n";
  EXPECT_NEAR(area(table, {.name = "dp_1", .base = -2.0}), 5.0 * 3.0 + 10.0 * 3.0, 1e-9);  // 5 and 10 m long
  EXPECT_NEAR(area(table, {.name = "dp_2", .base = -2.0}), 30.0, 1e-9);
  EXPECT_THAT(refusal<InputError>([&] { profile(table); }), HasSubstr("There are: dp_1, dp_2."));
}

TEST(GroundProfile, TakesSoilsByTheLevelOfTheirTops)
{
  const DxfRegions ground = profile("l,z\n0,0\n10,4\n20,0\n", {.base = -6.0});
  const std::string soils = "soilprofile_id;top_level;soil_name\nA;10;klei\nA;2;veen\nA;-2;zand\nA;-9;klei\nB;9;zand\n";
  const DxfRegions found = with_soils(ground, "soils.csv", soils, "A");
  ASSERT_EQ(found.regions.size(), 3u);
  EXPECT_EQ(found.regions[1].name, "veen");
  EXPECT_NEAR(signed_area(found.regions[0].polygon), 160.0, 1e-9);
  EXPECT_NEAR(signed_area(found.regions[1].polygon), 160.0 - 10.0, 1e-9);  // less the triangle above 2 m
  EXPECT_NEAR(signed_area(found.regions[2].polygon), 80.0, 1e-9);
  EXPECT_THAT(found.notes.back(), HasSubstr("below the base"));
  EXPECT_THAT(with_soils(ground, "soils.csv", "top;soil\n1;zand\n", "").notes.back(), HasSubstr("3 m above"));
  const auto refused = [&](const std::string& text, const std::string& name) {
    return refusal<InputError>([&] { with_soils(ground, "soils.csv", text, name); });
  };
  EXPECT_THAT(refused(soils, ""), HasSubstr("holds 2 profiles of soils"));
  EXPECT_THAT(refused(soils, "C"), HasSubstr("has no profile `C`"));
  EXPECT_THAT(refused("a;b\n1;2\n", ""), HasSubstr("is no table of soils"));
  EXPECT_THAT(refused("top;soil\nx;zand\n", ""), HasSubstr("in line 2"));
  EXPECT_THAT(refused("top;soil\n1;zand\n1;klei\n", ""), HasSubstr("has two soils with the top at 1 m"));
  EXPECT_EQ(with_soils(ground, "soils.csv", "top [cm];soil\n900;klei\n100;zand\n", "").regions.size(), 2u);
}

}  // namespace ground_profile_test
