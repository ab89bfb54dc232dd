#include "cli/commands.hpp"
#include "cli/run.hpp"

int main(int argc, char** argv) { return jointid::cli::run(argc, argv, jointid::cli::parse_all); }
