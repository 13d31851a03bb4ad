#include "batch/ranks.hpp"

#include "os/instructions.hpp"
#include "batch/engine.hpp"
#include "batch/rank_words.hpp"
#include "batch/samples.hpp"
#include "batch/study_text.hpp"

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace ranks_test {

constexpr auto patience = std::chrono::seconds(20);

class Child {
 public:
  template <class Task>
  explicit Child(Task&& task) : pid_(::fork())
  {
    if (pid_ != 0) return;
    int status = 1;
    try {
      task();
      status = 0;
    } catch (const std::exception& error) {
      std::fprintf(stderr, "%s\n", error.what());
    }
    ::_exit(status);
  }
  ~Child() { wait(); }
  int wait()
  {
    int status = 0;
    if (pid_ > 0) ::waitpid(pid_, &status, 0);
    pid_ = -1;
    return status;
  }

 private:
  pid_t pid_;
};

struct Job : StudyWithStores {
  using StudyWithStores::StudyWithStores;
  std::vector<std::string> warnings = {};
  const Launched launched{.rank = 0, .size = 3, .job = "7"};

  std::string table_of_threads() const { return study_csv(study, run("threads")); }
  auto worker(int rank, int threads = 1) const
  {
    return [this, rank, threads] {
      work_for_rank_0(study, of("lock"), {.rank = rank, .size = 3, .job = "7"}, threads, never_stop, patience);
    };
  }
  std::string table_of_ranks()
  {
    RankServer server(study, of("lock"), launched, [this](const std::string& what) { warnings.push_back(what); });
    return study_csv(study, run("ranks", {.ranks = &server}));
  }
  RankPlace place() const
  {
    for (int k = 0; k < 100; ++k) {
      if (std::filesystem::exists(of("lock") + "/ranks/rank_0"))
        return rank_place_of(read_file(of("lock") + "/ranks/rank_0")).value();
      ::usleep(50'000);
    }
    throw std::runtime_error("no rank 0");
  }
};

TEST(Ranks, MakeTheTableOfOneThread)
{
  for (const std::string& text :
      {column_study, field_study, changed(column_study, "number = 12", "number = 120\ncov = 0.3"),
          changed(column_study, "kind = \"monte_carlo\"",
              "kind = \"multilevel\"\ncoarse = { \"body[0].points_per_cell\" = [1, 1] }\npairs = 4")}) {
    Job job(text);
    const std::string table = job.table_of_threads();
    Child first(job.worker(1)), second(job.worker(2, 2));  // the own worker of rank 0 would not see that all is done
    EXPECT_EQ(job.table_of_ranks(), table);
    EXPECT_EQ(first.wait(), 0);
    EXPECT_EQ(second.wait(), 0);
    EXPECT_THAT(job.warnings, IsEmpty());
    EXPECT_EQ(study_csv(job.study, read_store(job.study, job.of("ranks")).rows), table) << "what was written";
    job.worker(2)();  // comes too late, and does not wait
  }
}

TEST(Ranks, SolveWhereAMethodAsks)
{
  Job job(column_study);
  job.study.settings.estimator = Estimator::subset;  // as if OpenTURNS asked
  const std::vector<std::vector<Real>> scores{{-1.0}, {1.0 / 3.0}, {0.5}, {2.0}};
  const auto draw = [&](Index n) { return draw_at(job.study, scores[static_cast<std::size_t>(n)]); };
  Realisations alone, shared;
  solve_realisations(job.study, job.of("threads"), {}, never_stop, {0, 1, 2, 3}, draw, alone);
  Child worker(job.worker(1));
  RankServer server(job.study, job.of("lock"), job.launched, [](const std::string&) {});
  const EngineOptions options{.ranks = &server};
  solve_realisations(job.study, job.of("ranks"), options, never_stop, {0, 1}, draw, shared);
  solve_realisations(job.study, job.of("ranks"), options, never_stop, {2, 3}, draw, shared);
  ASSERT_EQ(shared.size(), 4u);
  for (const auto& [n, row] : shared) EXPECT_TRUE(row.same_as(alone.at(n))) << n;
}

TEST(Ranks, AWorkerThatDiesLosesItsRealisationAlone)
{
  Job job(column_study);
  const std::string table = job.table_of_threads();
  Child dies([&] {
    const RankPlace place = job.place();
    std::optional<LineSocket> socket = connect_to("127.0.0.1", place.port, 2000);
    socket->send(line_of(RankHello{place.token, "rank 2 on here", head_of(job.study)}));
    std::string line;
    socket->receive(line, 20'000);
    socket.reset();
    job.worker(1)();  // only now, so that the other one has had its realisation
  });
  EXPECT_EQ(job.table_of_ranks(), table);
  EXPECT_THAT(job.warnings, ElementsAre("rank 2 on here is lost; realisation 0 goes to another worker"));
}

TEST(Ranks, ARealisationThatIsLostTwiceIsNamedAndTheOthersAreKept)
{
  Job job(column_study);
  Child all([&] {
    const RankPlace place = job.place();
    for (int k = 0; k < 2; ++k) {
      LineSocket socket = connect_to("127.0.0.1", place.port, 2000).value();
      socket.send(line_of(RankHello{place.token, "rank 2 on here", head_of(job.study)}));
      std::string line;
      socket.receive(line, 20'000);
    }
    job.worker(1)();
  });
  EXPECT_THAT(refusal<FileError>([&] { job.table_of_ranks(); }),
      StartsWith("realisation 0: 2 processes that solved it were lost\n  What else is solved is kept."));
  EXPECT_THAT(job.warnings, ElementsAre("rank 2 on here is lost; realisation 0 goes to another worker",
                                "rank 2 on here is lost; realisation 0 is given up, as it was lost before"));
  EXPECT_EQ(read_store(job.study, job.of("ranks")).rows.size(), 11u);
}

TEST(Ranks, StrangersAndOtherProgramsAreTurnedAway)
{
  Job job(column_study);
  Child all([&] {
    const RankPlace place = job.place();
    struct stat file = {};
    if (::stat((job.of("lock") + "/ranks").c_str(), &file) != 0 || (file.st_mode & 0077) != 0)
      throw std::runtime_error("others may read the file of rank 0");
    const auto answer = [&](const std::string& token, StoreHead head, const std::string& build) {
      head.build = build;
      LineSocket socket = connect_to("127.0.0.1", place.port, 2000).value();
      socket.send(line_of(RankHello{token, "rank 2 on here", head}));
      std::string line;
      socket.receive(line, 20'000);
      return line;
    };
    const StoreHead head = head_of(job.study);
    if (answer("guessed", head, head.build) != "refused\tthis is another study") throw std::runtime_error("token");
    if (!answer(place.token, head, "other").starts_with("refused\tit is build other of terp"))
      throw std::runtime_error("build");
    StoreHead other = head;
    other.study_digits = "9";
    if (!answer(place.token, other, head.build).starts_with("refused\twhat is drawn"))
      throw std::runtime_error("study");
    job.worker(1)();
  });
  job.table_of_ranks();
  EXPECT_EQ(all.wait(), 0);
  EXPECT_THAT(job.warnings, ElementsAre(StartsWith("rank 2 on here does not take part: it is build other of terp"),
                                StartsWith("rank 2 on here does not take part: what is drawn")));
}

TEST(Ranks, AWorkerDoesNotWaitWithoutEndForRankZero)
{
  const Job job(column_study);
  write_file_atomically(job.of("lock/ranks") + "/rank_0",
      text_of(RankPlace{.job = "6", .machine = "here", .token = "x", .port = 1, .addresses = {"127.0.0.1"}}));
  EXPECT_THAT(refusal<FileError>([&] {
    work_for_rank_0(
        job.study, job.of("lock"), {.rank = 1, .size = 3, .job = "7"}, 1, never_stop, std::chrono::seconds(1));
  }),
      AllOf(StartsWith("rank 1 on "), HasSubstr("finds no rank 0 within 1 s\n  All ranks must see the folder")))
      << "the file is of another job";
  EXPECT_THAT(refusal<FileError>([&] {
    work_for_rank_0(
        job.study, job.of("lock"), {.rank = 1, .size = 3, .job = "6"}, 1, never_stop, std::chrono::seconds(1));
  }),
      AllOf(StartsWith("rank 1 on "), HasSubstr("does not reach rank 0: it is gone")))
      << "nobody listens there";
}

}  // namespace ranks_test
