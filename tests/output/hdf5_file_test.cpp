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

TEST(Hdf5File, AnAttributeOfAnotherKindOrNumberIsRefused)
{
  const test::ScratchFolder folder;
  Hdf5File file(folder.path() + "/a.h5", Hdf5File::Mode::create);
  file.set_text("/", "text", "kPa");
  file.set_integers("/", "many", std::vector<std::int64_t>(4000, 7));
  for (const char* name : {"text", "many", "missing"}) {
    EXPECT_THAT(file_error_of([&] { file.real("/", name); }), HasSubstr(name));
    EXPECT_THAT(file_error_of([&] { file.integer("/", name); }), HasSubstr(name));
  }
  EXPECT_THAT(file_error_of([&] { file.real("/", "many"); }),
      HasSubstr("cannot read many in " + folder.path() + "/a.h5: it has 4000 values, one is expected"));
  EXPECT_THAT(file_error_of([&] { file.text("/", "many"); }), HasSubstr("it is no text of fixed length"));
}

TEST(Hdf5File, AShapeThatIsMoreThanTheFileCanHoldIsRefused)
{
  const test::ScratchFolder folder;
  const std::string path = folder.path() + "/a.h5";
  constexpr std::int64_t far = std::int64_t{1} << 40;
  {
    Hdf5File file(path, Hdf5File::Mode::create);
    file.create_table<Real>("/plain", {.chunk_rows = 64});
    file.create_table<Real>("/pressed", {.n_columns = 2, .chunk_rows = 64, .compression = 1});
    file.create_table<Real>("/sound", {.chunk_rows = 1 << 14, .compression = 1});
    file.create_table<Real>("/large_pieces", {.chunk_rows = 1 << 28, .compression = 1});
    file.create_table<Real>("/many_pieces", {.chunk_rows = 1, .compression = 1});
    file.create_table<Real>("/zeros", {.chunk_rows = 1 << 14, .compression = 9});
    file.write_rows<Real>("/plain", far, std::vector<Real>{1.0});
    file.write_rows<Real>("/pressed", far, std::vector<Real>{1.0, 2.0});
    file.write_rows<Real>("/many_pieces", 1 << 16, std::vector<Real>{1.0});
    file.write_rows<Real>("/sound", 0, std::vector<Real>{1.0, 2.0});
    file.write_rows<Real>("/zeros", 0, std::vector<Real>(1 << 20, 0.0));
  }
  const Hdf5File file(path, Hdf5File::Mode::read);
  for (const char* name : {"/plain", "/pressed", "/large_pieces", "/many_pieces"}) {
    EXPECT_THAT(file_error_of([&] { file.read<Real>(name); }),
        testing::AllOf(HasSubstr(name), HasSubstr("more than a file of")));
    EXPECT_THAT(file_error_of([&] { file.read_rows<Real>(name, 0, 1); }), HasSubstr("more than a file of"));
  }
  EXPECT_THAT(file.read<Real>("/sound"), ElementsAre(1.0, 2.0));
  EXPECT_EQ(file.read<Real>("/zeros").size(), 1u << 20);
}

TEST(Hdf5File, RowsOfWhatIsNoTableAreRefused)
{
  const test::ScratchFolder folder;
  Hdf5File file(folder.path() + "/a.h5", Hdf5File::Mode::create);
  file.write<Real>("/number", {}, std::vector<Real>{1.0});
  file.write<Real>("/box", {2, 1, 2}, std::vector<Real>{1.0, 2.0, 3.0, 4.0});
  file.write<Real>("/no_columns", {2, 0}, std::vector<Real>{});
  for (const char* name : {"/number", "/box", "/no_columns"}) {
    EXPECT_THAT(file_error_of([&] { file.read_rows<Real>(name, 0, 1); }),
        testing::AllOf(HasSubstr(name), HasSubstr("no table")));
    EXPECT_THAT(file_error_of([&] { file.write_rows<Real>(name, 0, std::vector<Real>{1.0}); }), HasSubstr("no table"));
    EXPECT_THAT(file_error_of([&] { file.cut_rows(name, 0); }), HasSubstr("no table"));
  }
}

TEST(Hdf5File, AFileThatIsNoHdf5IsNamed)
{
  const test::ScratchFolder folder;
  const std::string path = folder.path() + "/a.h5";
  write_file_atomically(path, "just text");
  EXPECT_THAT(
      file_error_of([&] { Hdf5File(path, Hdf5File::Mode::read); }), testing::StartsWith("cannot read " + path + ": "));
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
  EXPECT_THAT(
      file_error_of([&] { file.read<Real>("/velocity"); }), HasSubstr("cannot open /velocity in " + folder.path()));
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
