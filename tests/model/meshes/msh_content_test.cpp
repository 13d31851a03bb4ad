#include "model/meshes/msh_content.hpp"
#include "model/meshes/msh_text.hpp"
#include "support/catalogue.hpp"
#include "support/process.hpp"

namespace msh_content_test {

const std::string head_41 = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
const std::string square_41 =
    "$Nodes\n1 4 1 4\n2 1 0 4\n1\n2\n3\n4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n$EndNodes\n$Elements\n1 1 1 1\n2 1 3 1\n1 1 2 3 "
    "4\n$EndElements\n";

std::string refusal_of(const std::string& text)
{
  return refusal<MeshError>([&] { read_msh("m.msh", text); });
}

std::string changed(std::string text, const std::string& from, const std::string& to)
{
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(ReadMsh, ReadsNodesAndElements)
{
  const MshContent content = read_msh("m.msh", head_41 + square_41);
  EXPECT_THAT(content.node_numbers, ElementsAre(1, 2, 3, 4));
  EXPECT_THAT(content.places[2], ElementsAre(1.0, 1.0, 0.0));
  EXPECT_EQ(content.node_entities[2], (MshEntity{2, 1}));
  EXPECT_EQ((head_41 + square_41).substr(content.node_bytes[2], 6), "1 1 0\n");
  ASSERT_EQ(content.quads.size(), 1u);
  EXPECT_THAT(content.quads[0].nodes, ElementsAre(1, 2, 3, 4));
}

TEST(ReadMsh, FindsTheGroupsOfAnEntity)
{
  const std::string names = "$PhysicalNames\n1\n2 8 \"sand \"and\" clay\" \r\n$EndPhysicalNames\n",
                    entities = "$Entities\n1 0 1 0\n5 0 0 0 1 77\n1 0 0 0 1 1 0 2 8 -9 0\n$EndEntities\n";
  const MshContent content = read_msh("m.msh", head_41 + names + entities + square_41);
  EXPECT_EQ(content.group_names.at({2, 8}), "sand \"and\" clay");
  EXPECT_THAT(content.group_sets[content.quads[0].groups], ElementsAre(8, 9));
}

TEST(ReadMsh, PassesOverSectionsItDoesNotUse)
{
  const std::string comments = "$Comments\n$Nodes is a fine word, $EndComments too\n$EndComments\n";
  EXPECT_EQ(
      read_msh("m.msh", "words\n" + head_41 + comments + square_41 + "$Periodic\n1\n$EndPeriodic\n").quads.size(), 1u);
}

TEST(ReadMsh, TakesNumbersAtTheEdgeOfTheirRange)
{
  const std::string text = changed(changed(square_41, "1 1 0", "1e-400 1 0"), "\n3\n4", "\n3\n9223372036854775807");
  const MshContent content = read_msh("m.msh", head_41 + text);
  EXPECT_EQ(content.places[2][0], 0.0);
  EXPECT_EQ(content.node_numbers[3], 9223372036854775807);
}

TEST(ReadMsh, PassesOverParametersOfNodes)
{
  std::string text = changed(square_41, "2 1 0 4", "2 1 1 4");
  for (const std::string line : {"0 0 0", "1 0 0", "1 1 0", "0 1 0"})
    text = changed(text, "\n" + line + "\n", "\n" + line + " 0.5 0.25\n");
  EXPECT_THAT(read_msh("m.msh", head_41 + text).places[3], ElementsAre(0.0, 1.0, 0.0));
}

TEST(ReadMsh, TakesLinesThatEndInTheDosWay)
{
  std::string text;
  for (const char c : head_41 + square_41) text += c == '\n' ? "\r\n" : std::string(1, c);
  EXPECT_EQ(read_msh("m.msh", text).quads.size(), 1u);
}

TEST(ReadMsh, RefusesWhatIsNoMeshFile)
{
  EXPECT_THAT(refusal_of("Point(1) = {0, 0, 0};\n"),
      HasSubstr("m.msh:1: this is not a gmsh mesh: section $MeshFormat is expected first"));
  EXPECT_THAT(refusal_of(""), HasSubstr("m.msh:1: this is not a gmsh mesh"));
}

TEST(ReadMsh, RefusesBytesInTheOtherOrder)
{
  const std::string text = "$MeshFormat\n4.1 1 8\n" + bytes_of<std::int32_t>(0x01000000) + "\n$EndMeshFormat\n";
  EXPECT_EQ(refusal_of(text),
      "m.msh: byte 20: the file was written by a machine with another order of bytes. Save it as text (ASCII)");
}

TEST(ReadMsh, RefusesCutOffFiles)
{
  const std::string whole = head_41 + square_41;
  EXPECT_EQ(refusal_of(whole.substr(0, whole.find("$EndElements"))),
      "m.msh:20: the file ends before `$EndElements`: it is cut off");
  EXPECT_EQ(refusal_of(whole.substr(0, whole.find("$Elements"))),
      "m.msh:15: the file ends without section $Elements: it is cut off, or holds no mesh");
  EXPECT_THAT(refusal_of(head_41), HasSubstr("the file ends without section $Nodes"));
  EXPECT_EQ(refusal_of(head_41 + "$Comments\nhello"),
      "m.msh:4: section $Comments has no `$EndComments`: the file is cut off");
}

TEST(ReadMsh, RefusesWhatIsMalformedAndNamesTheLine)
{
  const std::string path = source_path("tests/model/meshes/msh.wrong");
  for (const WrongRow& row : read_catalogue(path))
    expect_row(path, row, refusal_of(changed(head_41 + square_41, row.before, row.after)));
  EXPECT_EQ(refusal_of(changed(head_41 + square_41, "1 1 0\n", "\x01\x02" + std::string(60, 'a'))),
      "m.msh:13: a coordinate is expected, got `??" + std::string(38, 'a') + "...`");
}

template <class... T>
std::string all_bytes_of(T... numbers)
{
  return (bytes_of(numbers) + ...);
}

TEST(ReadMsh, NamesTheByteInABinaryFile)
{
  const std::string head = "$MeshFormat\n4.1 1 8\n" + bytes_of<std::int32_t>(1) + "\n$EndMeshFormat\n$Nodes\n" +
                           all_bytes_of(1l, 2l, 1l, 2l, 0, 5, 0, 2l),
                    first = bytes_of(1l), places = all_bytes_of(0.5, 0.5, 0.0, 1.5, 0.5, 0.0);
  EXPECT_EQ(refusal_of(head + first + bytes_of(-3l) + places),
      fmt::format("m.msh: byte {}: a node number of at least 1 is expected, got -3", head.size() + 8));
  EXPECT_EQ(refusal_of(head + first + bytes_of(2l) + places.substr(0, 20)),
      fmt::format("m.msh: byte {}: the file ends where a coordinate is expected: it is cut off", head.size() + 32));
}

TEST(ReadMsh, KnowsWhereTheCoordinatesOfANodeStandAmongTheBytes)
{
  const std::string bytes = text_of(two_layers("41_binary"));
  const MshContent content = read_msh("m.msh", bytes);
  ASSERT_EQ(content.node_bytes.size(), 15u);
  for (std::size_t i = 0; i < content.places.size(); ++i)
    EXPECT_EQ(
        bytes.substr(content.node_bytes[i], 24), std::string(reinterpret_cast<const char*>(&content.places[i]), 24));
  EXPECT_EQ(content.node_entities[0], (MshEntity{0, 1}));
  EXPECT_EQ(content.node_entities[14], (MshEntity{2, 2}));
}

TEST(MshTypeName, KnowsTheCommonTypes)
{
  EXPECT_EQ(msh_type_name(2), "triangle");
  EXPECT_EQ(msh_type_name(3), "quadrilateral");
  EXPECT_EQ(msh_type_name(16), "quadrilateral with 8 nodes");
  EXPECT_EQ(msh_type_name(999), "");
}

}  // namespace msh_content_test
