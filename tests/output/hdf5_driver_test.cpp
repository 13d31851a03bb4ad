// HDF5 through a file that changes as a whole.
#include "output/hdf5_file.hpp"

#include "output/committed_file.hpp"
#include "output/files.hpp"
#include "support/paths.hpp"

#include <filesystem>

#include <gmock/gmock.h>

namespace terp {
namespace {

using testing::ElementsAre;

std::string make_file(const test::ScratchFolder& scratch)
{
  const std::string path = scratch.path() + "/a.h5";
  Hdf5File file(path, Hdf5File::Mode::create);
  file.create_table<Real>("/t", {.n_columns = 0, .chunk_rows = 4, .compression = 3});
  file.write_rows<Real>("/t", 0, std::vector<Real>{1, 2, 3, 4});
  file.set_integers("/", "n", {1});
  file.close();
  return path;
}

void add_rows(Hdf5File& file)
{
  file.write_rows<Real>("/t", 4, std::vector<Real>{5, 6, 7, 8});
  file.set_integers("/", "n", {2});
}

TEST(Hdf5Driver, AReaderSeesTheOldContentUntilTheFileIsClosed)
{
  const test::ScratchFolder scratch;
  const std::string path = make_file(scratch);
  Hdf5File writer(path, Hdf5File::Mode::commit, 10000);
  add_rows(writer);
  writer.flush();
  const std::string copy = scratch.path() + "/copy.h5";
  std::filesystem::copy_file(path, copy);  // as another process sees it
  EXPECT_THAT(Hdf5File(copy, Hdf5File::Mode::read).read<Real>("/t"), ElementsAre(1, 2, 3, 4));
  EXPECT_THAT(writer.read<Real>("/t"), ElementsAre(1, 2, 3, 4, 5, 6, 7, 8));
  writer.close();
  const Hdf5File file(path, Hdf5File::Mode::read);
  EXPECT_THAT(file.read<Real>("/t"), ElementsAre(1, 2, 3, 4, 5, 6, 7, 8));
  EXPECT_THAT(file.integers("/", "n"), ElementsAre(2));
}

TEST(Hdf5Driver, WhatIsNotClosedIsDropped)
{
  const test::ScratchFolder scratch;
  const std::string path = make_file(scratch), before = read_file(path);
  {
    Hdf5File file(path, Hdf5File::Mode::commit, 10000);
    add_rows(file);
  }
  EXPECT_EQ(read_file(path), before);
}

TEST(Hdf5Driver, ManySmallChangesGiveTheFileThatHdf5AloneWouldWrite)
{
  const test::ScratchFolder scratch;
  const std::string path = make_file(scratch);
  std::vector<Real> expected{1, 2, 3, 4};
  for (int k = 0; k < 300; ++k) {
    Hdf5File file(path, Hdf5File::Mode::commit);
    const std::vector<Real> rows{1.0 * k, 0.5 * k, -1.0 * k};
    file.write_rows<Real>("/t", std::ssize(expected), rows);
    expected.insert(expected.end(), rows.begin(), rows.end());
    file.close();
  }
  EXPECT_EQ(Hdf5File(path, Hdf5File::Mode::read).read<Real>("/t"), expected);
  EXPECT_THAT(std::filesystem::exists(journal_name(path)), false);
}

}  // namespace
}  // namespace terp
