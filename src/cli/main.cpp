#include "cli/program.hpp"

int main(int argc, char** argv) { return terp::answer(argc, argv, terp::call_command); }
