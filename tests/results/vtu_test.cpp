// VTK's XML files: their structure. That VTK reads them is shown in tests/vtk.
#include "results/vtu.hpp"

#include "output/compress.hpp"

#include <gmock/gmock.h>

namespace terp {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(Vtu, HasPointsCellsAndFieldsInBase64)
{
  const ExportFrame frame{.time = 0.5,
      .step = 10,
      .x = {1.0, 2.0, 3.0, 4.0},
      .fields = {{{"su", "Pa", 1}, {8000.0, 7000.0}}, {{"stress", "Pa", 4}, std::vector<Real>(8, 1.0)}}};
  const std::string text = vtu_text(frame);
  EXPECT_THAT(text, HasSubstr("<Piece NumberOfPoints=\"2\" NumberOfCells=\"2\">"));
  EXPECT_THAT(text, HasSubstr("Name=\"stress\" NumberOfComponents=\"4\" ComponentName0=\"xx\" ComponentName1=\"yy\" "
                              "ComponentName2=\"zz\" ComponentName3=\"xy\""));
  const std::uint64_t size = 16;
  const Real su[] = {8000.0, 7000.0};
  const std::string bytes =
      std::string(reinterpret_cast<const char*>(&size), 8) + std::string(reinterpret_cast<const char*>(su), 16);
  EXPECT_THAT(text, HasSubstr("Name=\"su\" format=\"binary\">" + base64(bytes) + "<"));
  const Real places[] = {1.0, 2.0, 0.0, 3.0, 4.0, 0.0};
  const std::uint64_t places_size = 48;
  EXPECT_THAT(text, HasSubstr(base64(std::string(reinterpret_cast<const char*>(&places_size), 8) +
                                     std::string(reinterpret_cast<const char*>(places), 48))));
}

TEST(Pvd, NamesEachFileWithItsTime)
{
  EXPECT_THAT(pvd_text({{0.0, "a.vtu"}, {0.1, "b.vtu"}}),
      testing::AllOf(HasSubstr("<DataSet timestep=\"0\" part=\"0\" file=\"a.vtu\"/>\n<DataSet timestep=\"0.1\" "
                               "part=\"0\" file=\"b.vtu\"/>")));
}

TEST(ComponentSuffixes, AreThoseOfVectorsAndTensors)
{
  EXPECT_THAT(component_suffixes(1), ElementsAre(""));
  EXPECT_THAT(component_suffixes(3), ElementsAre("_x", "_y", "_z"));
  EXPECT_THAT(component_suffixes(4), ElementsAre("_xx", "_yy", "_zz", "_xy"));
}

}  // namespace
}  // namespace terp
