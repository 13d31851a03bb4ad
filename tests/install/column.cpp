// A column in memory, by the installed library: prints where its front is.
#include "input/case_file.hpp"
#include "simulation/simulation.hpp"

#include <cstdio>

int main(int, char** arguments)
{
  terp::Simulation column(terp::read_case(arguments[1], {"mesh.cell=0.5", "time.end=0.2"}).values);
  column.advance_to(0.1);
  column.run();
  std::printf("front %.6f m\n", terp::summarise(column.model, column.state).front_x);
}
