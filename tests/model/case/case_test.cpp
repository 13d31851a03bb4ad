#include "model/case/case.hpp"
#include "support/test.hpp"

namespace case_test {

TEST(Case, FilesAreNamedRelativeToTheCaseFile)
{
  EXPECT_EQ(path_of("cases/dike", "mesh.msh"), "cases/dike/mesh.msh");
  EXPECT_EQ(path_of("cases/dike", "/data/mesh.msh"), "/data/mesh.msh");
  EXPECT_EQ(path_of("", "mesh.msh"), "mesh.msh");
}

TEST(Case, AFormulaOfTheVelocityGoesBeforeItsNumbers)
{
  BodyCase body;
  body.velocity = {1.0, 2.0};
  EXPECT_EQ(velocity_of(body, {3.0, 4.0}), (Vec<2>{1.0, 2.0}));
  body.velocity_at = [](Vec<2> x) { return Vec<2>{x[1], -x[0]}; };
  EXPECT_EQ(velocity_of(body, {3.0, 4.0}), (Vec<2>{4.0, -3.0}));
}

}  // namespace case_test
