#include "cli/problem/all_problems.hpp"

#include "cli/problem/problem_command.hpp"

namespace jointid::cli {

void add_problem(CLI::App& app, Chosen& chosen) { declare_problem(app, chosen, {.kinds = problems::all_kinds(), .all = true}); }

}  // namespace jointid::cli
