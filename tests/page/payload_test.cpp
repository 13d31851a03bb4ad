#include "page/payload.hpp"
#include "page/codec.hpp"
#include "io/results/depends.hpp"
#include "io/results/runs.hpp"
#include "support/older_run.hpp"
#include "support/page_data.hpp"

namespace payload_test {

using nlohmann::json;

struct PayloadTest : testing::Test {
  ScratchFolder scratch;
  Payload payload = make_payload({write_run(scratch.path() + "/mixed", [](Summary& s) { s.scheme = "mpm_mixed"; }),
                                     write_run(scratch.path() + "/gp")},
      {.written = "2026-11-21T10:00:00Z"});
  json document = json::parse(payload.json);

  std::string chunk(const json& part) const
  {
    return gunzip(test::from_base64(payload.chunks.at(part.at("chunk").get<std::size_t>())));
  }
  std::vector<float> floats(const json& part) const
  {
    const std::string bytes = unpack_words(chunk(part));
    std::vector<float> values(bytes.size() / sizeof(float));
    std::memcpy(values.data(), bytes.data(), bytes.size());
    return values;
  }
};

TEST_F(PayloadTest, NamesItsFormatAndItsRuns)
{
  EXPECT_EQ(document["format"], 2);
  EXPECT_EQ(document["kind"], "run");
  EXPECT_EQ(document["terp"], TERP_VERSION);
  EXPECT_EQ(document["written"], "2026-11-21T10:00:00Z");
  ASSERT_EQ(document["runs"].size(), 2);
  const json& run = document["runs"][1];
  EXPECT_EQ(run["name"], "gp");
  EXPECT_EQ(run["title"], "Column collapse, model 2: softening");
  EXPECT_EQ(run["scheme"], "mpm_gp");
  EXPECT_EQ(run["materials"][0]["name"], "clay");
  EXPECT_EQ(run["n_points"], 5);
  EXPECT_EQ(run["times"], (std::vector<Real>{0.0, 0.1, 0.2}));
  EXPECT_EQ(run["summary"]["scheme"], "mpm_gp");
  EXPECT_EQ(document["comparison"]["columns"], (std::vector<std::string>{"mixed", "gp"}));
}

TEST_F(PayloadTest, PlacesDecodeToThoseOfTheRun)
{
  const json& run = document["runs"][0];
  const json& x = run["positions"]["x"];
  const auto frames = decode_frames(chunk(x), x["frames"].get<std::size_t>(), x["points"].get<std::size_t>(),
      x["layout"] == "frame" ? Layout::by_frame : Layout::by_point);
  ASSERT_EQ(frames.size(), 3);
  const Real lo = x["lo"], hi = x["hi"];
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t p = 0; p < 5; ++p)
      EXPECT_NEAR(lo + (hi - lo) * frames[k][p] / 65535.0, sample_frame(static_cast<int>(k)).x[2 * p],
          0.501 * run["position_precision"].get<Real>());
}

TEST_F(PayloadTest, TablesAreColumnsOfFloatsInReadableUnits)
{
  const json& series = document["runs"][0]["series"];
  ASSERT_EQ(series["rows"], 2);
  const auto values = floats(series);
  ASSERT_EQ(values.size(), 2 * series["columns"].size());
  const auto& columns = series["columns"];
  for (std::size_t c = 0; c < columns.size(); ++c) {
    if (columns[c]["name"] == "front_x") {
      EXPECT_FLOAT_EQ(values[2 * c], 13.1f);
    }
    if (columns[c]["name"] == "kinetic") {
      EXPECT_FLOAT_EQ(values[2 * c], 1.25e-3f);
      EXPECT_EQ(columns[c]["unit"], "kJ/m");
    }
  }
  EXPECT_EQ(document["runs"][0]["histories"][0]["name"], "A");
  EXPECT_EQ(document["runs"][0]["histories"][0]["x"], 1.5);
}

TEST_F(PayloadTest, HasMeshOutlineAndSurfaces)
{
  const json& run = document["runs"][0];
  EXPECT_EQ(run["mesh"]["edges"]["count"], 160 * 31 + 161 * 30);
  EXPECT_EQ(floats(run["mesh"]["edges"]).size(), 4 * run["mesh"]["edges"]["count"].get<std::size_t>());
  EXPECT_EQ(run["outline"]["count"], 5);
  EXPECT_EQ(run["surfaces"]["offsets"].size(), 4);
  EXPECT_EQ(floats(run["surfaces"]).size(), 2 * run["surfaces"]["offsets"][3].get<std::size_t>());
}

TEST_F(PayloadTest, HasSoilsTheirColoursAndTheCaseThatGaveThem)
{
  const json& run = document["runs"][0];
  EXPECT_EQ(document["language"], "en");
  EXPECT_EQ(run["materials"][0]["soil"], "clay");
  EXPECT_EQ(run["materials"][0]["color"], "#a3c293");
  EXPECT_EQ(run["layers"][0]["soil"], "clay");
  EXPECT_TRUE(run["loads"].empty());
  EXPECT_TRUE(run["slip_planes"].empty());
  EXPECT_EQ(run["case_path"], scratch.path() + "/mixed/case.toml");
  EXPECT_EQ(run["case_digits"].get<std::string>().size(), 16u);
}

TEST_F(PayloadTest, HasLoadsAndSlipPlanesOfTheCase)
{
  const std::string folder = scratch.path() + "/gp", path = path_in(folder, case_file);
  test::forget_checksums(folder);
  write_file_atomically(
      path, read_file(path) +
                "\n[[load]]\nname = \"traffic\"\nfrom = 0\nto = 4\npressure = \"13 kPa\"\n"
                "[reference]\nslip_planes = [{ name = \"a\", method = \"Bishop\", factor_of_safety = 1.25, "
                "line = [[1, 2], [3, 0.5]] }, { name = \"b\", line = [[0, 0], [1, 1]] }]\n");
  write_file_atomically(path_in(folder, "loads.csv"),
      "time,load,pressure,width,force,x,y\n0,traffic,13000,4,52000,2,1\n0.2,traffic,13000,4,52000,2.5,1\n");
  payload = make_payload({folder}, {.written = "", .language = "nl"});
  document = json::parse(payload.json);
  EXPECT_EQ(document["language"], "nl");
  const json& run = document["runs"][0];
  ASSERT_EQ(run["loads"].size(), 1);
  EXPECT_EQ(run["loads"][0]["name"], "traffic");
  EXPECT_EQ(floats(run["loads"][0])[2], 13.0f);  // kPa; after the two times
  ASSERT_EQ(run["slip_planes"].size(), 2);
  EXPECT_EQ(run["slip_planes"][0]["factor_of_safety"], 1.25);
  EXPECT_EQ(run["slip_planes"][0]["points"][1][0], 3.0);
  EXPECT_TRUE(run["slip_planes"][1]["factor_of_safety"].is_null());
}

TEST_F(PayloadTest, SaysWhatSpeaksAgainstAnImport)
{
  test::forget_checksums(scratch.path() + "/gp");
  const std::string path = scratch.path() + "/gp/case.toml";
  write_file_atomically(path, read_file(path) +
                                  "\n[reference]\ndoubts = [\"A layer is missing.\", \"No POP.\"]\nassumed = "
                                  "[\"K0.\"]\nassumed_nl = [\"K0 aangenomen.\"]\n");
  const json alone = json::parse(make_payload({scratch.path() + "/gp"}, {}).json);
  const json english{"A layer is missing.", "No POP."};
  EXPECT_EQ(alone["runs"][0]["doubts"], (json{{"en", english}, {"nl", english}})) << "none in Dutch";
  write_file_atomically(path, read_file(path) + "doubts_nl = [\"Een laag ontbreekt.\", \"Geen POP.\"]\n");
  const json both = json::parse(make_payload({scratch.path() + "/gp"}, {}).json);
  EXPECT_EQ(both["runs"][0]["doubts"]["nl"], (json{"Een laag ontbreekt.", "Geen POP."}));
  EXPECT_EQ(alone["runs"][0]["assumed"], (json{{"en", {"K0."}}, {"nl", {"K0 aangenomen."}}}));
}

TEST_F(PayloadTest, SaysWhatWasChangedSinceTheImport)
{
  test::forget_checksums(scratch.path() + "/gp");
  const std::string path = scratch.path() + "/gp/case.toml", text = read_file(path);
  const std::string density =
      text.substr(text.find("density"), text.find('\n', text.find("density")) - text.find("density"));
  write_file_atomically(scratch.path() + "/gp/imported.toml",
      std::string(text).replace(text.find(density), density.size(), "density = 1234.5"));
  write_file_atomically(path, text + "\n[reference]\nimported = \"imported.toml\"\n");
  const json alone = json::parse(make_payload({scratch.path() + "/gp"}, {}).json);
  ASSERT_EQ(alone["runs"][0]["changed"]["en"].size(), 1);
  EXPECT_THAT(
      alone["runs"][0]["changed"]["en"][0].get<std::string>(), HasSubstr("weight was 1234.5 kg/m^3 in the import"));
  EXPECT_THAT(
      alone["runs"][0]["changed"]["nl"][0].get<std::string>(), HasSubstr("gewicht was bij het inlezen 1234,5 kg/m^3"));
}

TEST_F(PayloadTest, HasWhatTheOutcomeTurnsOnWhereTheFileBesideTheFolderIsOfThisRun)
{
  const auto depends = [&](const std::string& folder = "/gp") {
    return json::parse(make_payload({scratch.path() + folder}, {}).json)["runs"][0]["depends"];
  };
  EXPECT_TRUE(depends().is_null());
  const std::string path = scratch.path() + "/" + depends_file;
  write_file_atomically(path, decide("dike",
                                  {{"cells", "cells of 1 m", "stands", "gp"}, {"k0", "k0 x 0.8", "floods", "k0_x_0.8"},
                                      {"S", "S x 0.85", "stands", "s"}},
                                  {"material.clay.su_peak (a table in a file)"})
                                  .json);
  for (const char* folder : {"/gp", "/gp/"})
    EXPECT_EQ(depends(folder), (json{{"turns_on", {"k0"}}, {"does_not_turn_on", {"S"}},
                                   {"not_varied", {"material.clay.su_peak (a table in a file)"}}}));
  write_file_atomically(path, decide("dike", {{"cells", "cells of 1 m", "stands", "another"}}).json);
  EXPECT_TRUE(depends().is_null());
  for (const char* damaged : {"{", "[]", "{\"runs\": [3]}", "{\"runs\": [{\"folder\": \"gp\"}]}"}) {
    write_file_atomically(path, damaged);
    EXPECT_TRUE(depends().is_null()) << damaged;
  }
}

TEST_F(PayloadTest, HasTheFactorOfSafetyOfTheSameCaseBesideIt)
{
  const auto stability = [&] {
    return json::parse(make_payload({scratch.path() + "/gp"}, {}).json)["runs"][0]["stability"];
  };
  EXPECT_TRUE(stability().is_null());
  const std::string path = scratch.path() + "/stability/stability.json";
  make_folder(scratch.path() + "/stability");
  json found{{"factor_of_safety", 1.25}, {"uncertainty", 0.02}, {"mesh", {{"cells_over_depth", 7.5}}},
      {"case", read_file(scratch.path() + "/gp/case.toml")}, {"trials", json::array()}};
  write_file_atomically(path, found.dump());
  EXPECT_EQ(stability()["factor_of_safety"], 1.25);
  EXPECT_EQ(stability()["mesh"]["cells_over_depth"], 7.5);
  EXPECT_FALSE(stability().contains("trials"));
  found["case"] = "title = \"another\"";
  write_file_atomically(path, found.dump());
  EXPECT_TRUE(stability().is_null()) << "of another case";
  write_file_atomically(path, "{");
  EXPECT_TRUE(stability().is_null());
}

TEST_F(PayloadTest, ACaseThatCannotBeReadCostsTheMeshAndSaysSo)
{
  test::forget_checksums(scratch.path() + "/gp");
  write_file_atomically(scratch.path() + "/gp/case.toml", "title = ");
  const json alone = json::parse(make_payload({scratch.path() + "/gp"}, {}).json);
  EXPECT_EQ(alone["runs"][0]["mesh"]["edges"]["count"], 0);
  EXPECT_THAT(alone["runs"][0]["warnings"]["en"].dump(), HasSubstr("can no longer be read"));
  EXPECT_THAT(alone["runs"][0]["warnings"]["nl"].dump(), HasSubstr("niet meer te lezen"));
  EXPECT_TRUE(alone["comparison"].is_null());
}

TEST_F(PayloadTest, SaysWhatIsShown)
{
  EXPECT_THAT(payload.notes, ElementsAre(StartsWith("mixed: 3 frames, 5 points, places to "), StartsWith("gp: ")));
}

TEST(Payload, MayStandInsideAScriptOfThePageWhateverItsTextsHold)
{
  const ScratchFolder scratch;
  const std::string words = "</script><b>\"\n";
  const Payload payload = make_payload({write_run(scratch.path() + "/run", [&](Summary& s) { s.scheme = words; })}, {});
  EXPECT_EQ(payload.json.find('<'), std::string::npos);
  EXPECT_EQ(json::parse(payload.json)["runs"][0]["scheme"], words);
}

TEST(Payload, LeavesDamagedFramesOutAndNamesThem)
{
  const ScratchFolder scratch;
  const std::string folder = write_run(scratch.path() + "/run"), path = path_in(folder, frame_file(point_frames, 1));
  const auto head = [&] { return Frames(folder).times().size(); };
  std::string bytes = read_file(path);
  for (std::size_t at = bytes.size() / 3; head() == 3; at += 7) {  // until a bit that only a reading of values finds
    std::string damaged = bytes;
    damaged[at] = static_cast<char>(damaged[at] ^ 1);
    write_file_atomically(path, damaged);
    try {
      if (head() == 3) Frames(folder).places(1);  // what the page reads of every frame
    } catch (const FileError&) {
      break;
    }
  }
  const Payload payload = make_payload({folder}, {});
  EXPECT_THAT(payload.warnings, ElementsAre(HasSubstr(path + " is left out")));
  EXPECT_THAT(payload.notes[0], StartsWith("run: 2 frames, "));
  std::filesystem::remove(path_in(folder, frame_file(point_frames, 2)));
  EXPECT_THAT(make_payload({folder}, {}).notes[0], StartsWith("run: 1 frame, "));
}

}  // namespace payload_test
