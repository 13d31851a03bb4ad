// What all VTKHDF files share: components as VTK wants them, steps that are counted and cut.
#include "output/vtkhdf_steps.hpp"

#include "output/samples.hpp"
#include "support/paths.hpp"

#include <gmock/gmock.h>

namespace terp {
namespace {

using testing::ElementsAre;

const std::string speed_table = vtkhdf::root + "/PointData/speed";

/// A file with steps 0, 100, 200, ... and a table of two rows per step.
std::string write_steps(const std::string& folder, int n)
{
  const std::string path = folder + "/steps.vtkhdf";
  Hdf5File file(path, Hdf5File::Mode::create);
  file.create_group(vtkhdf::root);
  file.create_group(vtkhdf::steps);
  file.create_group(vtkhdf::steps + "/PointDataOffsets");
  file.create_table<std::int64_t>(vtkhdf::steps + "/PointDataOffsets/speed", {});
  vtkhdf::add_header(file, "85944171f73967e8");
  vtkhdf::add_steps(file);
  file.create_group(vtkhdf::root + "/PointData");
  file.create_table<Real>(speed_table, {});
  for (int k = 0; k < n; ++k) {
    vtkhdf::write_step(file, k, 0.5 * k, 100 * k, 2 * k);
    vtkhdf::write_integer(file, vtkhdf::steps + "/PointDataOffsets/speed", k, 2 * k);
    const std::array<Real, 2> speed{1.0 * k, -1.0 * k};
    file.write_rows<Real>(speed_table, 2 * k, speed);
    file.set_integers(vtkhdf::steps, "NSteps", {k + 1});
  }
  file.close();
  return path;
}

TEST(VtkhdfSteps, VectorsOfThePlaneGetAZAndScalarsStay)
{
  EXPECT_EQ(vtkhdf::n_columns(1), 0);
  EXPECT_EQ(vtkhdf::n_columns(2), 3);
  EXPECT_EQ(vtkhdf::n_columns(4), 4);
  EXPECT_THAT(vtkhdf::with_z({1.0, 2.0, 3.0, 4.0}), ElementsAre(1.0, 2.0, 0.0, 3.0, 4.0, 0.0));
  EXPECT_TRUE(vtkhdf::with_z({}).empty());
}

TEST(VtkhdfSteps, TheHeaderNamesFormatAndVersion)
{
  const test::ScratchFolder folder;
  const Hdf5File file(write_steps(folder.path(), 0), Hdf5File::Mode::read);
  EXPECT_EQ(file.text(vtkhdf::root, "Type"), "UnstructuredGrid");
  EXPECT_THAT(file.integers(vtkhdf::root, "Version"), ElementsAre(2, 0));
  EXPECT_EQ(file.text(vtkhdf::steps + "/Values", "unit"), "s");
}

TEST(VtkhdfSteps, AFileOfAnotherCaseOrAnotherNumberOfCellsOrPointsIsOfAnotherRun)
{
  const test::ScratchFolder folder;
  const std::string path = write_steps(folder.path(), 0);
  {
    Hdf5File file(path, Hdf5File::Mode::change);
    file.write<std::int64_t>(vtkhdf::root + "/NumberOfCells", {1}, std::vector<std::int64_t>{7});
    file.write<std::int64_t>(vtkhdf::root + "/NumberOfPoints", {1}, std::vector<std::int64_t>{9});
    file.close();
  }
  const Hdf5File file(path, Hdf5File::Mode::read);
  EXPECT_EQ(vtkhdf::why_of_another_run(file, "85944171f73967e8", {9, 7}), "");
  EXPECT_EQ(vtkhdf::why_of_another_run(file, "", {9, 7}), "");  // of a run whose case is not known
  EXPECT_EQ(vtkhdf::why_of_another_run(file, "85944171f73967e8", {9, 8}), "it has 7 cells, the run 8");
  EXPECT_EQ(vtkhdf::why_of_another_run(file, "85944171f73967e8", {8, 7}), "it has 9 points, the run 8");
  EXPECT_EQ(vtkhdf::why_of_another_run(file, "af63dc4c8601ec8c", {9, 7}),
      "it is of a run of another case (`case` in it is 85944171f73967e8, of this run af63dc4c8601ec8c)");
}

TEST(VtkhdfSteps, AreCountedUpToATimeStep)
{
  const test::ScratchFolder folder;
  const Hdf5File file(write_steps(folder.path(), 4), Hdf5File::Mode::read);
  EXPECT_EQ(vtkhdf::count_steps(file, -1), 0);
  EXPECT_EQ(vtkhdf::count_steps(file, 0), 1);
  EXPECT_EQ(vtkhdf::count_steps(file, 199), 2);
  EXPECT_EQ(vtkhdf::count_steps(file, 200), 3);
  EXPECT_EQ(vtkhdf::count_steps(file, 1000), 4);
}

TEST(VtkhdfSteps, AStepThatWasNotCountedIsNone)
{
  const test::ScratchFolder folder;
  Hdf5File file(write_steps(folder.path(), 3), Hdf5File::Mode::change);
  vtkhdf::write_step(file, 3, 1.5, 300, 6);  // killed before NSteps was written
  EXPECT_EQ(vtkhdf::count_steps(file, 1000), 3);
}

TEST(VtkhdfSteps, WhereATableIsNotWhatItMustBeNothingIsCut)
{
  const test::ScratchFolder folder;
  Hdf5File file(write_steps(folder.path(), 4), Hdf5File::Mode::change);
  const std::string box = vtkhdf::root + "/box", missing = vtkhdf::root + "/missing";
  file.write<Real>(box, {8, 1, 1}, std::vector<Real>(8));
  for (const vtkhdf::StepTable& table : {vtkhdf::StepTable{missing, 2, 0}, vtkhdf::StepTable{box, 2, 0},
           vtkhdf::StepTable{speed_table, 3, 0}, vtkhdf::StepTable{speed_table, 2, 3}}) {
    EXPECT_THAT(test::file_error_of([&] { vtkhdf::cut_steps(file, 150, {table}); }), testing::HasSubstr(table.name));
    EXPECT_EQ(file.integer(vtkhdf::steps, "NSteps"), 4);
    EXPECT_THAT(file.shape(speed_table), ElementsAre(8));
  }
  file.cut_rows(vtkhdf::steps + "/NumberOfParts", 3);
  EXPECT_THAT(test::file_error_of([&] { vtkhdf::cut_steps(file, 150, {}); }),
      testing::HasSubstr("NumberOfParts has the shape 3; 4 steps of 1 rows are due"));
}

TEST(VtkhdfSteps, CuttingDropsEveryTableOfTheLaterSteps)
{
  const test::ScratchFolder folder;
  Hdf5File file(write_steps(folder.path(), 4), Hdf5File::Mode::change);
  vtkhdf::cut_steps(file, 150, {{speed_table, 2, 0}});
  EXPECT_THAT(file.integers(vtkhdf::steps, "NSteps"), ElementsAre(2));
  EXPECT_THAT(file.read<Real>(vtkhdf::steps + "/Values"), ElementsAre(0.0, 0.5));
  EXPECT_THAT(file.read<std::int64_t>(vtkhdf::steps + "/PointDataOffsets/speed"), ElementsAre(0, 2));
  EXPECT_THAT(file.read<Real>(speed_table), ElementsAre(0.0, 0.0, 1.0, -1.0));
}

TEST(VtkhdfSteps, AFieldSaysItsUnitAndTheNamesOfItsComponents)
{
  const test::ScratchFolder folder;
  Hdf5File file(folder.path() + "/field.h5", Hdf5File::Mode::create);
  file.create_table<Real>("/stress", {.n_columns = 4});
  file.create_table<Real>("/pressure", {});
  vtkhdf::describe_field(file, "/stress", "Pa", 4);
  vtkhdf::describe_field(file, "/pressure", "Pa", 1);
  EXPECT_EQ(file.text("/stress", "components"), "xx yy zz xy");
  EXPECT_EQ(file.text("/pressure", "unit"), "Pa");
}

}  // namespace
}  // namespace terp
