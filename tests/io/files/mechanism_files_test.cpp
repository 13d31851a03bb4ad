#include "io/files/mechanism_files.hpp"
#include "io/files/hdf5_file.hpp"
#include "run/loop/simulation.hpp"
#include "support/cases.hpp"

namespace mechanism_files_test {

StabilityResult with_mechanism(const Case& c)
{
  Simulation s(c);
  const PointMotion before = look_at_points(s.state);
  PointMotion now = before;
  for (std::size_t k = 0; k < now.x.size(); k += 2)
    if (now.x[k] > 2.0) now.x[k] += 1e-3, now.strain[2 * k + 3] += 1e-3;
  StabilityResult r;
  Mechanism m = find_mechanism(s.model, s.state, before, now, {}, 10.0);
  m.factor = 1.25;
  r.mechanism = std::make_shared<const Mechanism>(std::move(m));
  r.mesh = s.model.mesh;
  return r;
}

TEST(MechanismFiles, AreAFrameTheMeshAndAPicture)
{
  const std::string folder = testing::TempDir() + "mechanism_files_test";
  std::filesystem::create_directories(folder);
  const Case c = column("mpm_gp");
  const StabilityResult r = with_mechanism(c);
  write_mechanism(folder, c, r, "0123456789abcdef");
  EXPECT_THAT(read_file(folder + "/mechanism.svg"),
      AllOf(HasSubstr("mechanism with all strengths divided by 1.250"), HasSubstr("slip surface"),
          HasSubstr("shear strain in the last window"), Not(HasSubstr("before the first step"))));
  const Hdf5File frame(folder + "/mechanism/frames/points_00000.vtkhdf", Hdf5File::Mode::read);
  EXPECT_EQ(frame.text("/", "case"), "0123456789abcdef");
  EXPECT_EQ(frame.text("/VTKHDF/PointData/displacement_increment", "unit"), "m");
  EXPECT_TRUE(std::filesystem::exists(folder + "/mechanism/mesh.vtkhdf"));
  EXPECT_TRUE(std::filesystem::exists(folder + "/mechanism/results.vtkhdf.series"));
  write_mechanism(folder, c, r, "0123456789abcdef");  // once more: the same names
  write_mechanism(folder, c, {}, "0123456789abcdef");
  EXPECT_TRUE(std::filesystem::is_empty(folder)) << "without a mechanism none of an earlier search stays";
  std::filesystem::remove_all(folder);
  write_mechanism(folder, c, {}, "0123456789abcdef");
  EXPECT_FALSE(std::filesystem::exists(folder)) << "nothing without a mechanism";
}

}  // namespace mechanism_files_test
