#include "os/launcher.hpp"
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
  const Launched open_mpi =
      launched({{"OMPI_COMM_WORLD_RANK", "3"}, {"OMPI_COMM_WORLD_SIZE", "64"}, {"PMIX_NAMESPACE", "77"}});
  EXPECT_EQ(open_mpi.rank, 3);
  EXPECT_EQ(open_mpi.size, 64);
  EXPECT_EQ(open_mpi.job, "77.");
  EXPECT_EQ(launched({{"PMI_RANK", "1"}, {"PMI_SIZE", "2"}}).rank, 1);
  EXPECT_EQ(launched({{"PMI_RANK", "1"}, {"PMI_SIZE", "2"}}).job, "") << "it does not say";
  const Launched slurm =
      launched({{"SLURM_PROCID", "5"}, {"SLURM_STEP_NUM_TASKS", "8"}, {"SLURM_JOB_ID", "12"}, {"SLURM_STEP_ID", "0"}});
  EXPECT_EQ(slurm.rank, 5);
  EXPECT_EQ(slurm.size, 8);
  EXPECT_EQ(slurm.job, "12.0");
}

TEST(Launcher, AnMpirunWithinAJobOfSlurmCounts)
{
  const Launched both = launched({{"SLURM_PROCID", "0"}, {"SLURM_STEP_NUM_TASKS", "2"}, {"OMPI_COMM_WORLD_RANK", "6"},
      {"OMPI_COMM_WORLD_SIZE", "7"}});
  EXPECT_EQ(both.rank, 6);
  EXPECT_EQ(both.size, 7);
}

TEST(Launcher, WhatMakesNoSenseIsAlone)
{
  EXPECT_TRUE(launched({}).is_alone());
  EXPECT_TRUE(launched({{"SLURM_PROCID", "0"}, {"SLURM_NTASKS", "64"}}).is_alone()) << "the script of a batch job";
  EXPECT_TRUE(launched({{"OMPI_COMM_WORLD_RANK", "1"}}).is_alone());
  EXPECT_TRUE(launched({{"OMPI_COMM_WORLD_RANK", "4"}, {"OMPI_COMM_WORLD_SIZE", "4"}}).is_alone());
  EXPECT_TRUE(launched({{"PMI_RANK", "-1"}, {"PMI_SIZE", "4"}}).is_alone());
  EXPECT_TRUE(launched({{"PMI_RANK", "1x"}, {"PMI_SIZE", "4"}}).is_alone());
}

}  // namespace launcher_test
