#include "batch/rank_words.hpp"
#include "support/test.hpp"

namespace rank_words_test {

TEST(RankWords, ComeBackAsTheyWereSaid)
{
  const RankPlace place{
      .job = "77.", .machine = "node1", .token = "abc", .port = 4321, .addresses = {"192.0.2.7", "127.0.0.1"}};
  const auto back = rank_place_of(text_of(place));
  ASSERT_TRUE(back);
  EXPECT_EQ(back->job, "77.");
  EXPECT_EQ(back->machine, "node1");
  EXPECT_EQ(back->token, "abc");
  EXPECT_EQ(back->port, 4321);
  EXPECT_THAT(back->addresses, ElementsAre("192.0.2.7", "127.0.0.1"));
  EXPECT_FALSE(rank_place_of(text_of(place).substr(0, 30)));
  EXPECT_FALSE(rank_place_of("something else\n1\n2\n3\n4\n5\n6\n"));
  const RankHello hello{.token = "abc",
      .name = "rank 3 on node1",
      .head = {.version = "0.1.0", .case_digits = "1", .study_digits = "2", .build = "3", .instructions = "avx2"}};
  const auto heard = rank_hello_of(line_of(hello));
  ASSERT_TRUE(heard);
  EXPECT_EQ(heard->token, "abc");
  EXPECT_EQ(heard->name, "rank 3 on node1");
  EXPECT_EQ(heard->head, hello.head);
  EXPECT_FALSE(rank_hello_of("hello 2\ta\tb\tc\td\te\tf\tg"));
  EXPECT_FALSE(rank_hello_of("GET / HTTP/1.1"));
}

}  // namespace rank_words_test
