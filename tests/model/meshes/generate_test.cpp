// What needs gmsh is skipped where it is not installed.
#include "model/meshes/generate.hpp"
#include "model/meshes/check_mesh.hpp"
#include "model/meshes/gmsh_file.hpp"
#include "model/meshes/mesh_quality.hpp"
#include "os/process.hpp"
#include "support/environment.hpp"
#include "support/meshes.hpp"
#include "support/process.hpp"
#include <sys/wait.h>
#include <unistd.h>
#include <csignal>

namespace generate_test {

PolygonMesh rectangle()
{
  PolygonMesh mesh;
  mesh.polygon = {{0.0, 0.0}, {4.0, 0.0}, {4.0, 2.0}, {0.0, 2.0}};
  mesh.cell = 0.1;
  mesh.edges = {{"bottom", {0}}, {"walls", {1, 3}}};
  return mesh;
}

/// A slope 1 in 3 on a base that dips, a bay cut out to the right: area by the shoelace formula below.
PolygonMesh slope()
{
  PolygonMesh mesh;
  mesh.polygon = {{0.0, 0.3}, {6.0, 0.0}, {6.0, 1.0}, {5.2, 1.0}, {5.2, 1.4}, {4.4, 1.4}, {2.3, 2.1}, {0.0, 2.1}};
  mesh.cell = 0.12;
  mesh.edges = {{"base", {0}}, {"right", {1}}, {"surface", {5, 6}}};
  return mesh;
}

/// A clay dike, 5 m high, 1:3 outside and 1:2 inside, with berm and ditch, on two layers; no thin wedge is shared.
PolygonMesh dike()
{
  PolygonMesh mesh;
  mesh.polygon = {{-15.0, -5.0}, {50.0, -5.0}, {50.0, 9.0}, {-15.0, 9.0}};
  mesh.cell = 0.5;
  mesh.follow = {{{-15, -5}, {50, -5}, {50, -2}, {-15, -2}},
      {{-15, -2}, {50, -2}, {50, 0}, {39, 0}, {37, -1.5}, {36, -1.5}, {34, 0}, {32, 0}, {28, 2}, {24, 2}, {18, 5},
          {15, 5}, {0, 0}, {-15, 0}}};
  return mesh;
}

Real median_size(const Mesh<2>& mesh)
{
  std::vector<Real> size;
  for (Index e = 0; e < mesh.n_cells(); ++e) size.push_back(std::sqrt(mesh.geometry(e).volume));
  std::nth_element(size.begin(), size.begin() + size.size() / 2, size.end());
  return size[size.size() / 2];
}

/// Positions along the segment a-b of the nodes that lie on it, ascending, from 0 to 1.
std::vector<Real> nodes_on(const Mesh<2>& mesh, Vec<2> a, Vec<2> b)
{
  const Real length = std::hypot(b[0] - a[0], b[1] - a[1]);
  std::vector<Real> found;
  for (const Vec<2>& x : mesh.nodes) {
    const Real t = ((x[0] - a[0]) * (b[0] - a[0]) + (x[1] - a[1]) * (b[1] - a[1])) / (length * length);
    const Real off = ((b[0] - a[0]) * (x[1] - a[1]) - (b[1] - a[1]) * (x[0] - a[0])) / length;
    if (t > -1e-12 && t < 1.0 + 1e-12 && std::abs(off) < 1e-12) found.push_back(t);
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::string file_of(const PolygonMesh& polygon) { return generate_mesh(polygon).path; }

class GenerateMesh : public testing::Test {
 protected:
  void SetUp() override
  {
    if (!run_process({"gmsh", "--version"}, 60.0).found) GTEST_SKIP() << "gmsh is not installed";
  }
  Mesh<2> mesh_of(const PolygonMesh& polygon) { return generate_mesh(polygon).mesh; }

  ScratchFolder scratch_;
  Variable cache_{"XDG_CACHE_HOME", scratch_.path()};
};

TEST_F(
    GenerateMesh, FillsThePolygonWithConvexQuadrilaterals)  // read_gmsh refuses triangles and cells that are not convex
{
  const auto mesh = mesh_of(slope());
  Real area = 0.0;
  const auto& x = slope().polygon;
  for (std::size_t k = 0; k < x.size(); ++k)
    area += 0.5 * (x[k][0] * x[(k + 1) % x.size()][1] - x[k][1] * x[(k + 1) % x.size()][0]);
  EXPECT_NEAR(total_area(mesh), area, 1e-9);
  EXPECT_GT(mesh.smallest_altitude, 0.0);
}

TEST_F(GenerateMesh, NamesTheEdgesThatHaveNames)
{
  const auto lengths = lengths_of_sides(mesh_of(slope()));
  EXPECT_EQ(lengths.size(), 3u);
  EXPECT_NEAR(lengths.at("base"), std::hypot(6.0, 0.3), 1e-9);
  EXPECT_NEAR(lengths.at("right"), 1.0, 1e-9);
  EXPECT_NEAR(lengths.at("surface"), std::hypot(2.1, 0.7) + 2.3, 1e-9);
}

TEST_F(GenerateMesh, HasTheSizeThatWasAskedFor)
{
  for (int variant = 0; variant < 3; ++variant) {
    auto polygon = slope();
    polygon.variant = variant;
    EXPECT_NEAR(median_size(mesh_of(polygon)), 0.12, 0.15 * 0.12) << "variant " << variant;
    polygon = dike();
    polygon.variant = variant;
    EXPECT_NEAR(median_size(mesh_of(polygon)), 0.5, 0.15 * 0.5) << "variant " << variant;
  }
}

TEST_F(GenerateMesh, IsMadeOfSquaresWhereSquaresFit)
{
  const auto mesh = mesh_of(rectangle());
  EXPECT_EQ(mesh.n_cells(), 800);
  EXPECT_NEAR(mesh.smallest_altitude, 0.1, 1e-7);  // gmsh spaces nodes along a line to about 1e-8
}

TEST_F(GenerateMesh, LosesLittleOfTheTimeStepToItsSmallestCell)  // as gmsh leaves them: 0.38 and 0.16 of the size
{
  auto unstructured = rectangle();
  unstructured.variant = 1;
  EXPECT_GT(mesh_of(unstructured).smallest_altitude, 0.5 * 0.1);
  EXPECT_GT(mesh_of(dike()).smallest_altitude, 0.45 * 0.5);
}

/// Share of the cells that are squares of this size whose first side lies in this direction [deg].
Real share_of_squares(const Mesh<2>& mesh, Real cell, Real turn)
{
  const Real angle = turn * std::numbers::pi / 180.0;
  int n = 0;
  for (Index e = 0; e < mesh.n_cells(); ++e) {
    const auto& map = mesh.geometry(e).map;
    const auto is_side = [&](Vec<2> half) {
      const Real along = std::abs(half[0] * std::cos(angle) + half[1] * std::sin(angle)),
                 across = std::abs(half[1] * std::cos(angle) - half[0] * std::sin(angle));
      return std::abs(std::max(along, across) - 0.5 * cell) < 1e-6 * cell && std::min(along, across) < 1e-6 * cell;
    };
    const bool is_parallelogram = std::hypot(map.twist[0], map.twist[1]) < 1e-6 * cell;
    if (is_parallelogram && is_side(map.axis_xi) && is_side(map.axis_eta)) ++n;
  }
  return static_cast<Real>(n) / static_cast<Real>(mesh.n_cells());
}

TEST_F(GenerateMesh, IsMadeOfTurnedSquaresBehindAStripAlongTheSides)
{
  for (const Real turn : {10.0, 22.5, 45.0, -22.5}) {
    auto polygon = rectangle();
    polygon.turn = turn;
    const auto mesh = mesh_of(polygon);
    EXPECT_NEAR(total_area(mesh), 8.0, 1e-9);
    EXPECT_GT(share_of_squares(mesh, 0.1, turn), 0.5) << turn;  // of 20 by 40 cells the strip takes two to four
    EXPECT_GT(mesh.smallest_altitude, 0.5 * 0.1) << turn;
    EXPECT_NEAR(mesh.n_cells(), 800, 0.1 * 800) << turn;
    EXPECT_NEAR(lengths_of_sides(mesh).at("bottom"), 4.0, 1e-9);
    EXPECT_NEAR(lengths_of_sides(mesh).at("walls"), 4.0, 1e-9);
  }
  auto along = rectangle();
  along.turn = 10.0;
  EXPECT_LT(share_of_squares(mesh_of(along), 0.1, 0.0), 0.05);
}

TEST_F(GenerateMesh, HasSmallerCellsInABox)
{
  auto polygon = rectangle();
  polygon.refine = {{{}, {1.0, 0.0}, {2.0, 0.8}, 0.04, 0.3}};
  const auto mesh = mesh_of(polygon);
  Real inside = 0.0, far = 0.0;
  int n_inside = 0, n_far = 0;
  for (Index e = 0; e < mesh.n_cells(); ++e) {
    const Vec<2> x = mesh.centres[e];
    if (x[0] > 1.1 && x[0] < 1.9 && x[1] < 0.7) inside += std::sqrt(mesh.geometry(e).volume), ++n_inside;
    if (x[0] > 3.0) far += std::sqrt(mesh.geometry(e).volume), ++n_far;
  }
  EXPECT_NEAR(inside / n_inside, 0.04, 0.006);
  EXPECT_NEAR(far / n_far, 0.1, 0.015);
}

TEST_F(GenerateMesh, HasSmallerCellsAlongALine)
{
  auto polygon = rectangle();
  polygon.refine = {{{{0.5, 0.0}, {1.0, 1.0}, {1.0, 2.0}}, {}, {}, 0.04, 0.3}};
  const auto mesh = mesh_of(polygon);
  Real near = 0.0;
  int n_near = 0;
  for (Index e = 0; e < mesh.n_cells(); ++e)
    if (std::abs(mesh.centres[e][0] - 1.0) < 0.03 && mesh.centres[e][1] > 1.0)
      near += std::sqrt(mesh.geometry(e).volume), ++n_near;
  EXPECT_NEAR(near / n_near, 0.04, 0.01);
  EXPECT_NEAR(total_area(mesh), 8.0, 1e-9);
}

TEST_F(GenerateMesh, FollowsOutlines)
{
  const auto mesh = mesh_of(dike());
  const auto outline = dike().follow[1];
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const Vec<2> a = outline[k], b = outline[(k + 1) % outline.size()];
    const auto on = nodes_on(mesh, a, b);
    ASSERT_GE(on.size(), 2u);
    EXPECT_NEAR(on.front(), 0.0, 1e-12);
    EXPECT_NEAR(on.back(), 1.0, 1e-12);
    for (std::size_t i = 1; i < on.size(); ++i)
      EXPECT_LT((on[i] - on[i - 1]) * std::hypot(b[0] - a[0], b[1] - a[1]), 1.1) << "gap on line " << k;
  }
  EXPECT_NEAR(total_area(mesh), 65.0 * 14.0, 1e-9);
}

TEST_F(GenerateMesh, CutsOutlinesAtTheDomain)
{
  auto polygon = rectangle();
  polygon.follow = {
      {{1.0, -1.0}, {2.5, -1.0}, {2.5, 1.33}, {1.0, 1.0}}, {{2.0, 0.5}, {9.0, 0.5}, {9.0, 0.9}, {2.0, 0.9}}};
  const auto mesh = mesh_of(polygon);
  EXPECT_NEAR(total_area(mesh), 8.0, 1e-9);
  EXPECT_NEAR(lengths_of_sides(mesh).at("bottom"), 4.0, 1e-9);
  EXPECT_GE(nodes_on(mesh, {2.5, 0.0}, {2.5, 1.33}).size(), 12u);
  EXPECT_GE(nodes_on(mesh, {2.0, 0.9}, {4.0, 0.9}).size(), 18u);
}

TEST_F(GenerateMesh, RepeatsItselfToTheBit)
{
  for (int variant = 0; variant < 2; ++variant) {
    auto polygon = slope();
    polygon.variant = variant;
    const std::string path = file_of(polygon), first = text_of(path);
    std::filesystem::remove_all(scratch_.path() + "/terp");
    EXPECT_EQ(file_of(polygon), path);
    EXPECT_EQ(text_of(path), first);
  }
}

TEST_F(GenerateMesh, IsMadeAlsoWhereItCannotBeKept)
{
  std::ofstream(scratch_.path() + "/file") << "not a folder";
  const Variable cache("XDG_CACHE_HOME", scratch_.path() + "/file");
  const GeneratedMesh made = generate_mesh(rectangle());
  EXPECT_EQ(made.mesh.n_cells(), 800);
  EXPECT_EQ(made.path, "");
}

/// Puts the mesh of another size where that of `polygon` is kept, to see whether it is taken.
Index put_another(const PolygonMesh& polygon, const std::string& path)
{
  auto other = polygon;
  other.cell = 0.2;
  const GeneratedMesh made = generate_mesh(other);
  EXPECT_NE(made.path, path);
  std::filesystem::copy_file(made.path, path, std::filesystem::copy_options::overwrite_existing);
  return made.mesh.n_cells();
}

TEST_F(GenerateMesh, TakesItsMeshFromTheCache)
{
  const std::string path = file_of(rectangle());
  EXPECT_THAT(path, StartsWith(scratch_.path() + "/terp/meshes/"));
  const auto folder = std::filesystem::directory_iterator(scratch_.path() + "/terp/meshes");
  EXPECT_EQ(std::distance(begin(folder), end(folder)), 1);
  const Index n = put_another(rectangle(), path);
  EXPECT_EQ(mesh_of(rectangle()).n_cells(), n);
}

TEST_F(GenerateMesh, TakesTheNewestOfAnyVersionFromTheCacheWhereGmshIsNotInstalled)
{
  const std::string path = file_of(rectangle()), other = path.substr(0, path.rfind('-')) + "-1.msh";
  std::filesystem::copy_file(path, other);
  const Index n = put_another(rectangle(), path);
  const Variable nowhere("PATH", scratch_.path());
  const auto time = std::filesystem::last_write_time(path);
  std::filesystem::last_write_time(other, time - std::chrono::seconds(5));
  EXPECT_EQ(mesh_of(rectangle()).n_cells(), n);
  std::filesystem::last_write_time(other, time + std::chrono::seconds(5));
  EXPECT_EQ(mesh_of(rectangle()).n_cells(), 800);
}

TEST_F(GenerateMesh, MakesAnewWhatCannotBeReadInTheCache)
{
  const std::string path = file_of(rectangle()), whole = text_of(path);
  for (const std::size_t kept : {std::size_t{0}, std::size_t{500}, whole.size() - 3}) {
    std::filesystem::resize_file(path, kept);
    EXPECT_EQ(mesh_of(rectangle()).n_cells(), 800) << kept << " bytes";
    EXPECT_EQ(text_of(path), whole);
  }
}

TEST_F(GenerateMesh, GivesDifferentMeshesOfTheSameSize)
{
  std::vector<Vec<2>> centres;
  for (int variant = 1; variant <= 3; ++variant) {
    auto polygon = rectangle();
    polygon.variant = variant;
    const auto mesh = mesh_of(polygon);
    EXPECT_NEAR(median_size(mesh), 0.1, 0.015);
    EXPECT_THAT(centres, Not(Contains(mesh.centres[mesh.n_cells() / 2])));
    centres.push_back(mesh.centres[mesh.n_cells() / 2]);
  }
}

TEST_F(GenerateMesh, IgnoresTheUsersGmshOptions)
{
  const std::string first = text_of(file_of(rectangle()));
  std::filesystem::remove_all(scratch_.path() + "/terp");
  for (const char* name : {"/.gmshrc", "/.gmsh-options"})
    std::ofstream(scratch_.path() + name) << "Mesh.MeshSizeFactor = 0.5;\nMesh.SaveAll = 1;\n";
  const Variable home("HOME", scratch_.path());
  EXPECT_EQ(text_of(file_of(rectangle())), first);
}

std::string error_of(const PolygonMesh& polygon, const GmshTimes& times = {})
{
  return refusal<MeshError>([&] { generate_mesh(polygon, times); });
}

/// A stand-in for gmsh that knows its version and then does as the script says.
void write_gmsh(const std::string& folder, const std::string& script)
{
  write_text(folder + "/gmsh", "#!/bin/sh\n[ \"$1\" = --version ] && echo 9.9 && exit 0\n" + script);
  std::filesystem::permissions(folder + "/gmsh", std::filesystem::perms::owner_all);
}

/// False for what is gone and for a zombie that nobody has waited for.
bool runs(pid_t pid)
{
  std::ifstream file("/proc/" + std::to_string(pid) + "/stat");
  std::string number, name, state;
  return (file >> number >> name >> state) && state != "Z";
}

TEST(GenerateMeshWithoutGmsh, SaysHowToGetItAndWhatElseToDo)
{
  const ScratchFolder empty;
  const Variable path("PATH", empty.path()), cache("XDG_CACHE_HOME", empty.path());
  const std::string text = error_of(rectangle());
  EXPECT_THAT(
      text, AllOf(HasSubstr("gmsh is not installed"), HasSubstr("apt-get install gmsh"), HasSubstr("[mesh] file = ")));
}

TEST(GenerateMeshWithoutGmsh,
    LeavesNothingBehindWhenItIsEnded)  // a stand-in that takes a minute; we are asked to end while it runs
{
  const ScratchFolder folder;
  const std::string started = folder.path() + "/started";
  write_gmsh(folder.path(), "echo $$ > '" + started + "'\nexec /bin/sleep 60\n");
  const std::string temporary = folder.path() + "/tmp";
  std::filesystem::create_directory(temporary);
  const Variable path("PATH", folder.path()), cache("XDG_CACHE_HOME", folder.path()), place("TMPDIR", temporary);
  for (const int signal : {SIGTERM, SIGKILL}) {
    std::filesystem::remove(started);
    const pid_t child = fork();
    if (child == 0) {
      error_of(rectangle());
      _exit(1);
    }
    pid_t gmsh = 0;
    for (int k = 0; k < 500 && !(std::ifstream(started) >> gmsh); ++k) usleep(20000);
    ASSERT_GT(gmsh, 0);
    kill(child, signal);
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal);
    for (int k = 0; k < 250 && runs(gmsh); ++k) usleep(20000);
    EXPECT_FALSE(runs(gmsh)) << "signal " << signal;
    EXPECT_TRUE(signal == SIGKILL || std::filesystem::is_empty(temporary));
  }
}

TEST(GenerateMeshWithoutGmsh, SaysWhichRecipeGmshIsAtAndStopsAfterATimeForAll)  // a stand-in that takes a minute
{
  const ScratchFolder folder;
  write_gmsh(folder.path(), "exec /bin/sleep 60\n");
  const Variable path("PATH", folder.path()), cache("XDG_CACHE_HOME", folder.path());
  testing::internal::CaptureStderr();
  EXPECT_THAT(error_of(rectangle(), {.recipe = 1.5, .all = 3.0, .first_word = 0.5}),
      ContainsRegex("from the polygon: gmsh did not finish in [01]\\.[0-9]+ s"));
  EXPECT_THAT(testing::internal::GetCapturedStderr(),
      AllOf(StartsWith("gmsh, recipe 1 of 3: 1 s of at most 2 s\n"),
          HasSubstr("gmsh, recipe 1 of 3 gave no mesh (gmsh did not finish in 1.5 s); trying the next\n"),
          ContainsRegex("recipe 2 of 3 gave no mesh .gmsh did not finish in [01]\\.[0-9]+ s"),
          Not(HasSubstr("recipe 3"))));
}

TEST(GenerateMeshWithoutGmsh, SaysWhatGmshSaidWhenItFails)  // a stand-in that knows its version and nothing else
{
  const ScratchFolder folder;
  write_gmsh(folder.path(), "echo 'Error: no memory' >&2\nexit 1\n");
  const Variable path("PATH", folder.path()), cache("XDG_CACHE_HOME", folder.path());
  EXPECT_THAT(
      error_of(rectangle()), HasSubstr("gmsh made no mesh of quadrilaterals from the polygon: Error: no memory"));
  auto fine = rectangle();
  fine.cell = 0.005;
  testing::internal::CaptureStderr();
  error_of(fine);
  EXPECT_THAT(testing::internal::GetCapturedStderr(),
      AllOf(HasSubstr("gmsh is at work on about 0.32 million cells"),
          HasSubstr("gmsh, recipe 1 of 3 gave no mesh (Error: no memory); trying the next\n")));
}

}  // namespace generate_test
