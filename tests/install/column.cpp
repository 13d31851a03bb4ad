// A column in memory, by the installed library: prints where its front is.
#include "run/measure/followers.hpp"
#include "io/case/case_file.hpp"
#include "run/loop/simulation.hpp"

#include <cstdio>

int main(int, char** arguments)
{
  const terp::CaseFile file = terp::read_case(arguments[1], {"mesh.cell=0.5", "time.end=0.2"});
  terp::Simulation column(file.values, 1, terp::all_followers());
  column.advance_to(0.1);
  column.run();
  std::printf("front %.6f m\n", terp::summarise(column.model, column.state).front_x);
}
