#include "os/launcher.hpp"

#include "math/errors.hpp"
#include "support/test.hpp"

namespace launcher_test {

Launched launched(const std::map<std::string, std::string>& variables)
{
  return find_launch([&](const char* name) {
    const auto there = variables.find(name);
    return there != variables.end() ? there->second.c_str() : nullptr;
  });
}

TEST(Launcher, ReadsWhatEachLauncherSays)
{
  const Launched open_mpi = launched({{"OMPI_COMM_WORLD_RANK", "3"}, {"OMPI_COMM_WORLD_SIZE", "64"}});
  EXPECT_EQ(open_mpi.rank, 3);
  EXPECT_EQ(open_mpi.size, 64);
  EXPECT_TRUE(open_mpi.shares_machine && open_mpi.is_silent);
  EXPECT_EQ(launched({{"PMI_RANK", "1"}, {"PMI_SIZE", "2"}}).rank, 1);
  const Launched slurm = launched({{"SLURM_PROCID", "0"}, {"SLURM_STEP_NUM_TASKS", "8"}});
  EXPECT_EQ(slurm.rank, 0);
  EXPECT_EQ(slurm.size, 8);
  EXPECT_TRUE(slurm.shares_machine && !slurm.is_silent);
}

TEST(Launcher, AnMpirunWithinAJobOfSlurmCounts)
{
  const Launched both = launched({{"SLURM_PROCID", "0"}, {"SLURM_STEP_NUM_TASKS", "2"}, {"OMPI_COMM_WORLD_RANK", "6"},
      {"OMPI_COMM_WORLD_SIZE", "7"}});
  EXPECT_EQ(both.rank, 6);
  EXPECT_EQ(both.size, 7);
}

std::map<std::string, std::string> array_of_slurm(const char* task, const char* n, const char* first, const char* step)
{
  return {{"SLURM_ARRAY_TASK_ID", task}, {"SLURM_ARRAY_TASK_COUNT", n}, {"SLURM_ARRAY_TASK_MIN", first},
      {"SLURM_ARRAY_TASK_STEP", step}};
}

TEST(Launcher, ATaskOfAnArrayHasItsPlaceWhateverItsNumber)
{
  const Launched last = launched(array_of_slurm("9", "4", "3", "2"));  // --array=3-9:2
  EXPECT_EQ(last.rank, 3);
  EXPECT_EQ(last.size, 4);
  EXPECT_FALSE(last.shares_machine || last.is_silent) << "it has a terminal of its own";
  EXPECT_EQ(launched(array_of_slurm("0", "4", "0", "1")).rank, 0);
  EXPECT_EQ(launched(array_of_slurm("7", "1", "7", "1")).size, 1);
  auto job = array_of_slurm("2", "3", "1", "1");
  job.insert({{"SLURM_PROCID", "3"}, {"SLURM_STEP_NUM_TASKS", "4"}});
  EXPECT_EQ(launched(job).rank, 7) << "the second job of three, each with four ranks";
  EXPECT_EQ(launched(job).size, 12);
  EXPECT_TRUE(launched(job).is_silent);
}

TEST(Launcher, AnArrayWithGapsIsRefused)
{
  for (const auto& [task, step] : {std::pair{"9", "1"}, {"4", "2"}, {"2", "1"}, {"3", "0"}})
    EXPECT_THAT(refusal<FileError>([&] { launched(array_of_slurm(task, "3", "3", step)); }),
        AllOf(StartsWith(std::string("SLURM_ARRAY_TASK_ID is ") + task + ", of 3 tasks: the array has gaps"),
            HasSubstr("--array=1-3")))
        << task << ' ' << step;
}

TEST(Launcher, WhatMakesNoSenseIsAlone)
{
  const std::map<std::string, std::string> without[] = {{}, {{"SLURM_PROCID", "0"}, {"SLURM_NTASKS", "64"}},
      {{"OMPI_COMM_WORLD_RANK", "1"}}, {{"OMPI_COMM_WORLD_RANK", "4"}, {"OMPI_COMM_WORLD_SIZE", "4"}},
      {{"PMI_RANK", "-1"}, {"PMI_SIZE", "4"}}, {{"PMI_RANK", "1x"}, {"PMI_SIZE", "4"}}, {{"SLURM_ARRAY_TASK_ID", "4"}}};
  for (const auto& variables : without)
    EXPECT_EQ(launched(variables).size, 1) << (variables.empty() ? "" : variables.begin()->first);
}

}  // namespace launcher_test
