#include "io/results/import_changes.hpp"

#include "support/catalogue.hpp"
#include "support/process.hpp"

namespace import_changes_test {

const std::string imported = text_of(source_path("tests/io/results/imported.toml"));

TEST(ImportChanges, AreToldAsTheCatalogueHasThem)
{
  const std::string path = source_path("tests/io/results/changes.wrong");
  for (const WrongRow& row : read_catalogue(path)) {
    std::string all;
    for (const Sentence& said : import_changes(parse_toml(imported), parse_toml(spoil(imported, row))))
      all += (all.empty() ? "" : "\n") + said.en + '\n' + said.nl;
    expect_row(path, row, all);
  }
}

TEST(ImportChanges, OfTablesOverDepthAreTheirNumbers)
{
  const std::string table = "[material.clay]\nsu_peak = { depth = [[0, 8e3]] }\n";
  EXPECT_THAT(in_english(import_changes(
                  parse_toml(table), parse_toml(std::string(table).replace(table.find("8e3"), 3, "9e3")))),
      ElementsAre("clay: `su_peak.depth` was [[0, 8000.0]] in the import, is [[0, 9000.0]] here."));
}

TEST(ImportChanges, AreOfTheFileThatTheCaseNames)
{
  const ScratchFolder folder;
  const Node now = parse_toml(std::string(imported).replace(imported.find("= 26.5"), 6, "= 30.0"));
  EXPECT_THAT(changes_since_import(parse_toml("title = \"a\""), folder.path()), IsEmpty());
  const auto unknown = changes_since_import(now, folder.path());
  ASSERT_THAT(unknown, SizeIs(1));
  EXPECT_THAT(unknown[0].en, StartsWith("What changed since the import is not known: "));
  EXPECT_THAT(unknown[0].nl, StartsWith("Wat sinds het inlezen is veranderd, is niet bekend: "));
  std::ofstream(folder.path() + "/imported.toml") << imported;
  EXPECT_THAT(changes_since_import(now, folder.path()), SizeIs(1));
}

}  // namespace import_changes_test
