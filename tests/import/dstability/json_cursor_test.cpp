#include "import/dstability/json_cursor.hpp"

#include "support/test.hpp"

namespace json_cursor_test {

struct Read {
  JsonNode tree;
  StixNotes notes{"f.stix"};
  JsonCursor cursor;

  explicit Read(const std::string& text) : tree(read_json(text, "f.stix, m.json")), cursor(tree, "m.json", notes) {}
  std::string faults()
  {
    return refusal<InputError>([&] { notes.finish(); });
  }
};

TEST(JsonCursor, TakesEmptyNumbersAsNotGiven)
{
  Read read(R"({"a":"NaN","b":"-","c":null,"d":"Infinity","e":"","f":7.5})");
  for (const char* key : {"a", "b", "c", "d", "e", "none"}) EXPECT_TRUE(std::isnan(read.cursor.number(key))) << key;
  EXPECT_EQ(read.cursor.number("f"), 7.5);
  EXPECT_EQ(read.cursor.required("f", 1e3), 7500.0);
  EXPECT_EQ(read.faults(), "");
}

TEST(JsonCursor, SaysWhereAValueIsOfAnotherKind)
{
  Read read(R"({"List":[{"a":{}}]})");
  read.cursor.list("List")[0].number("a");
  EXPECT_EQ(
      read.faults(), "f.stix, m.json, List[0].a: is no number\n  Got an object. An empty number is \"NaN\" or null.");
  Read other(R"({"a":"x","b":3,"c":"yes"})");
  other.cursor.required("a");
  other.cursor.text("b");
  other.cursor.flag("c");
  other.cursor.id("none");
  other.cursor.object("b");
  try {
    other.notes.finish();
    ADD_FAILURE();
  } catch (const InputError& error) {
    std::vector<std::string> texts;
    for (const Problem& p : error.problems()) texts.push_back(p.key + " " + p.what);
    EXPECT_THAT(texts, ElementsAre("f.stix, m.json, a needs a number", "f.stix, m.json, b is not a text",
                           "f.stix, m.json, c is not true or false", "f.stix, m.json, none needs an id",
                           "f.stix, m.json, b is not an object"));
  }
}

TEST(JsonCursor, ReadsPlacesAndLines)
{
  Read read(R"({"L":[{"X":3,"Z":1},{"X":2,"Z":"NaN"},{"X":1,"Z":5}],"P":{"X":1},"N":null})");
  EXPECT_THAT(read.cursor.places_given("L"), ElementsAre(Vec<2>{3.0, 1.0}, Vec<2>{1.0, 5.0}));
  EXPECT_TRUE(std::isnan(read.cursor.place_if_given("P")[1]));
  EXPECT_THAT(read.cursor.line_to_the_right("N"), IsEmpty());
  read.cursor.line("L", 4);
  EXPECT_THAT(read.faults(), HasSubstr("m.json, L[1].Z: needs a number\n  Got the text \"NaN\"."));
}

TEST(JsonCursor, RemarksOnLinesThatRunBack)
{
  Read read(R"({"L":[{"X":0,"Z":1},{"X":4,"Z":2},{"X":3,"Z":5},{"X":9,"Z":5}]})");
  EXPECT_THAT(read.cursor.line_to_the_right("L"), SizeIs(4));
  const auto remarks = read.notes.finish();
  ASSERT_THAT(remarks, SizeIs(1));
  EXPECT_THAT(remarks[0].what, StartsWith("This line runs back"));
}

TEST(JsonCursor, TellsOnceOfAKeyThatNobodyAskedFor)
{
  Read read(R"({"L":[{"a":1,"b":2},{"a":1,"b":2}],"c":3})");
  for (JsonCursor& entry : read.cursor.list("L")) {
    entry.number("a");
    entry.tell_unknown();
  }
  read.cursor.pass_over({"c"});
  read.cursor.tell_unknown();
  const auto remarks = read.notes.finish();
  ASSERT_THAT(remarks, SizeIs(1));
  EXPECT_EQ(remarks[0].where, "m.json, L[].b");
  EXPECT_EQ(remarks[0].what, "This key is not known to Terp and was not used (2 times).");
}

}  // namespace json_cursor_test
