#include "io/files/hdf5_file.hpp"
#include "io/files/files.hpp"
#include "io/files/samples.hpp"
#include "io/files/small_disk.hpp"
#include <chrono>
#include <thread>

namespace hdf5_file_test {

constexpr Hdf5File::Layout packed{.packed = true};

struct Hdf5FileTest : testing::Test {
  const ScratchFolder scratch;
  const std::string path = scratch.path() + "/a.h5";
};

TEST_F(Hdf5FileTest, PackedArraysAreReadBackAlsoWhereTheyComeInPieces)
{
  Hdf5File file(path, Hdf5File::Mode::create);
  std::vector<Real> rows(600'000);
  for (std::size_t k = 0; k < rows.size(); ++k) rows[k] = std::sin(static_cast<Real>(k));
  const std::span<const Real> all(rows);
  file.write<Real>("/group/t", {200'000, 3}, all.first(300'003), 0, packed);
  file.write<Real>("/group/t", {200'000, 3}, all.subspan(300'003), 100'001, packed);
  EXPECT_EQ(file.read<Real>("/group/t"), rows);
  file.write<Real>("/single", {600'000}, all, 0, {true, Hdf5File::Number::float32});
  EXPECT_EQ(file.read<Real>("/single"), as_single(rows));
  EXPECT_NO_THROW(file.check_values());
}

TEST_F(Hdf5FileTest, EqualContentGivesEqualBytesWheneverItIsWritten)
{
  for (const char* name : {"/a.h5", "/b.h5"}) {
    Hdf5File file(scratch.path() + name, Hdf5File::Mode::create);
    file.set_real("/", "time", 0.5);
    file.write<Real>("/group/plain", {3}, std::vector<Real>{1.0, 2.0, 3.0});
    file.write<Real>("/group/packed", {3}, std::vector<Real>{1.0, 2.0, 3.0}, 0, packed);
    file.close();
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // HDF5's time stamps have seconds
  }
  EXPECT_EQ(read_file(path), read_file(scratch.path() + "/b.h5"));
}

TEST_F(Hdf5FileTest, MembersComeInTheOrderOfTheirCreation)
{
  Hdf5File file(path, Hdf5File::Mode::create);
  file.create_group("/g");
  for (const char* name : {"/g/z", "/g/a", "/g/m"}) file.write<std::int64_t>(name, {1}, std::vector<std::int64_t>{1});
  EXPECT_THAT(file.members("/g"), ElementsAre("z", "a", "m"));
}

TEST_F(Hdf5FileTest, AttributesAreReadBack)
{
  Hdf5File file(path, Hdf5File::Mode::create);
  file.set_text("/", "unit", "Pa");
  file.set_real("/", "time", 1.0 / 3.0);
  file.set_integers("/", "version", {2, 0});
  EXPECT_EQ(file.text("/", "unit"), "Pa");
  EXPECT_EQ(file.real("/", "time"), 1.0 / 3.0);
  EXPECT_THAT(file.integers("/", "version"), ElementsAre(2, 0));
}

TEST_F(Hdf5FileTest, AnAttributeOfAnotherKindOrNumberIsRefused)
{
  Hdf5File file(path, Hdf5File::Mode::create);
  file.set_text("/", "text", "kPa");
  file.set_integers("/", "many", std::vector<std::int64_t>(4000, 7));
  for (const char* name : {"text", "many", "missing"}) {
    EXPECT_THAT(file_error_of([&] { file.real("/", name); }), HasSubstr(name));
    EXPECT_THAT(file_error_of([&] { file.integer("/", name); }), HasSubstr(name));
  }
  EXPECT_THAT(file_error_of([&] { file.real("/", "many"); }),
      HasSubstr("cannot read many in " + scratch.path() + "/a.h5: it has 4000 values, one is expected"));
  EXPECT_THAT(file_error_of([&] { file.text("/", "many"); }), HasSubstr("it is no text of fixed length"));
}

TEST_F(Hdf5FileTest, AShapeThatIsMoreThanTheFileCanHoldIsRefused)
{
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the address sanitizer ends the program where memory is refused";
#endif
  constexpr std::int64_t far = std::int64_t{1} << 40;
  {
    Hdf5File file(path, Hdf5File::Mode::create);
    const std::vector<Real> one{1.0};
    file.write<Real>("/plain", {far}, one);
    file.write<Real>("/pressed", {far, 2}, std::vector<Real>{1.0, 2.0}, 0, packed);
    file.write<Real>("/zeros", {1 << 20}, std::vector<Real>(1 << 20, 0.0), 0, packed);
  }
  const Hdf5File file(path, Hdf5File::Mode::read);
  for (const char* name : {"/plain", "/pressed"})
    EXPECT_THAT(file_error_of([&] { file.read<Real>(name); }),
        AllOf(HasSubstr(name), AnyOf(HasSubstr("more than a file of"), HasSubstr("more than there is memory for"))));
  EXPECT_THAT(file_error_of([&] { file.check_values(); }), HasSubstr("more than "));
  EXPECT_EQ(file.read<Real>("/zeros").size(), 1u << 20);
}

TEST_F(Hdf5FileTest, AFileThatIsNoHdf5IsNamed)
{
  write_file_atomically(path, "just text");
  EXPECT_THAT(file_error_of([&] { Hdf5File(path, Hdf5File::Mode::read); }), StartsWith("cannot read " + path + ": "));
}

TEST_F(Hdf5FileTest, TheSystemsReasonIsGiven)
{
  EXPECT_EQ(file_error_of([] { Hdf5File("/no/such/a.h5", Hdf5File::Mode::create); }),
      "cannot write /no/such/a.h5: No such file or directory");
}

TEST_F(Hdf5FileTest, AMissingDatasetIsNamedWithItsFile)
{
  Hdf5File file(path, Hdf5File::Mode::create);
  EXPECT_THAT(
      file_error_of([&] { file.read<Real>("/velocity"); }), HasSubstr("cannot open /velocity in " + scratch.path()));
}

TEST_F(Hdf5FileTest, AFullDiskIsNoticedEvenWhereNoSpaceWasReserved)
{
  const SmallDisk disk(64 << 10);
  if (!disk.is_there()) GTEST_SKIP() << "cannot mount a small disk";
  Hdf5File file(disk.path() + "/a.h5", Hdf5File::Mode::create);
  disk.fill();
  std::vector<Real> rows(4096);  // HDF5 keeps one chunk back until the array is closed
  for (std::size_t k = 0; k < rows.size(); ++k) rows[k] = std::sin(static_cast<Real>(k));
  EXPECT_THAT(file_error_of([&] { file.write<Real>("/t", {4096}, rows, 0, packed); }),
      AllOf(HasSubstr("/t in " + disk.path()), HasSubstr("No space left on device")));
}

}  // namespace hdf5_file_test
