// What Terp needs from HDF5: tables that grow and shrink, attributes, clear errors.
#include "output/hdf5_file.hpp"

#include "output/files.hpp"
#include "output/samples.hpp"
#include "output/small_disk.hpp"

#include <filesystem>

#include <gmock/gmock.h>

namespace terp {
namespace {

using test::file_error_of;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(Hdf5File, ATableGrowsShrinksAndIsOverwrittenFromARow)
{
  const test::ScratchFolder folder;
  Hdf5File file(folder.path() + "/a.h5", Hdf5File::Mode::create);
  file.create_table<Real>("/t", {.n_columns = 2, .chunk_rows = 3, .compression = 3});
  file.write_rows<Real>("/t", 0, std::vector<Real>{1, 2, 3, 4, 5, 6});
  file.write_rows<Real>("/t", 1, std::vector<Real>{7, 8});
  EXPECT_THAT(file.read<Real>("/t"), ElementsAre(1, 2, 7, 8));
  file.cut_rows("/t", 1);
  EXPECT_THAT(file.shape("/t"), ElementsAre(1, 2));
  file.cut_rows("/t", 5);  // cutting never adds rows
  EXPECT_THAT(file.shape("/t"), ElementsAre(1, 2));
}

TEST(Hdf5File, MembersComeInTheOrderOfTheirCreation)
{
  const test::ScratchFolder folder;
  Hdf5File file(folder.path() + "/a.h5", Hdf5File::Mode::create);
  file.create_group("/g");
  for (const char* name : {"/g/z", "/g/a", "/g/m"}) file.write<std::int64_t>(name, {1}, std::vector<std::int64_t>{1});
  EXPECT_THAT(file.members("/g"), ElementsAre("z", "a", "m"));
}

TEST(Hdf5File, AttributesAreReadBackAndReplaced)
{
  const test::ScratchFolder folder;
  Hdf5File file(folder.path() + "/a.h5", Hdf5File::Mode::create);
  file.set_text("/", "unit", "kPa");
  file.set_text("/", "unit", "Pa");
  file.set_real("/", "time", 1.0 / 3.0);
  file.set_integers("/", "version", {2, 0});
  EXPECT_EQ(file.text("/", "unit"), "Pa");
  EXPECT_EQ(file.real("/", "time"), 1.0 / 3.0);
  EXPECT_THAT(file.integers("/", "version"), ElementsAre(2, 0));
}

TEST(Hdf5File, AFileThatIsNoHdf5IsNamed)
{
  const test::ScratchFolder folder;
  const std::string path = folder.path() + "/a.h5";
  write_file_atomically(path, "just text");
  EXPECT_THAT(file_error_of([&] { Hdf5File(path, Hdf5File::Mode::read); }),
              testing::StartsWith("cannot read " + path + ": "));
}

TEST(Hdf5File, TheSystemsReasonIsGiven)
{
  EXPECT_EQ(file_error_of([] { Hdf5File("/no/such/a.h5", Hdf5File::Mode::create); }),
            "cannot write /no/such/a.h5: No such file or directory");
}

TEST(Hdf5File, AMissingDatasetIsNamedWithItsFile)
{
  const test::ScratchFolder folder;
  Hdf5File file(folder.path() + "/a.h5", Hdf5File::Mode::create);
  EXPECT_THAT(file_error_of([&] { file.read<Real>("/velocity"); }),
              HasSubstr("cannot open /velocity in " + folder.path()));
}

TEST(Hdf5File, AFullDiskIsNoticedEvenWhereNoSpaceWasReserved)
{
  const test::SmallDisk disk(64 << 10);
  if (!disk.is_there()) GTEST_SKIP() << "cannot mount a small disk";
  Hdf5File file(disk.path() + "/a.h5", Hdf5File::Mode::create);
  file.create_table<Real>("/t", {.n_columns = 0, .chunk_rows = 4096, .compression = 1});
  disk.fill();
  std::vector<Real> rows(4096);  // HDF5 keeps one chunk back until the table is closed
  for (std::size_t k = 0; k < rows.size(); ++k) rows[k] = std::sin(static_cast<Real>(k));
  EXPECT_THAT(file_error_of([&] { file.write_rows<Real>("/t", 0, rows); }),
              testing::AllOf(HasSubstr("/t in " + disk.path()), HasSubstr("No space left on device")));
}

TEST(Hdf5File, MayBeReadWhileItIsOpenForWriting)
{
  const test::ScratchFolder folder;
  const std::string path = folder.path() + "/a.h5";
  Hdf5File writer(path, Hdf5File::Mode::create);
  writer.set_integers("/", "n", {4});
  writer.flush();
  const std::string copy = folder.path() + "/copy.h5";
  std::filesystem::copy_file(path, copy);  // as another process sees it
  EXPECT_THAT(Hdf5File(copy, Hdf5File::Mode::read).integers("/", "n"), ElementsAre(4));
}

}  // namespace
}  // namespace terp
