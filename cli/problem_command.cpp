#include <filesystem>
#include <fstream>
#include <iterator>

#include "cli/commands.hpp"
#include "cli/table.hpp"
#include "base/error.hpp"
#include "problems/coupling_problem.hpp"
#include "problems/loading_curves.hpp"
#include "problems/modal_set.hpp"
#include "problems/rig_two.hpp"

namespace jointid::cli {

ExitCode execute(const ProblemListArguments&, std::ostream& out) {
  Table table({{"name", Align::left}, {"what", Align::left}});
  for (const auto& problem : problems::list()) table.add({problem.name, problem.description});
  for (const auto& curve : problems::loading_curves()) table.add({curve.name, curve.description});
  for (const auto& problem : problems::list_coupling()) table.add({problem.name, problem.description});
  for (const auto& rig : problems::list_rig_two()) table.add({rig.name, rig.description});
  for (const auto& set : problems::list_modal_sets()) table.add({set.name, set.description});
  out << table.text(0);
  return ExitCode::done;
}

namespace {

/// Throws InputError where files of that name are in the folder and `problem write` has not made them: its truth.json names the problem.
void check_folder(const ProblemWriteArguments& arguments) {
  std::error_code ignored;
  std::ifstream truth(arguments.directory / "truth.json");
  const std::string text{std::istreambuf_iterator<char>(truth), {}};
  const bool is_own = text.find("\"name\": \"" + arguments.name + "\"") != std::string::npos;
  if (is_own) return;
  for (const auto& entry : std::filesystem::directory_iterator(arguments.directory, ignored)) {
    const std::string name = entry.path().filename().string();
    const bool is_in_the_way = name == "truth.json" || name.starts_with(arguments.name + ".") || name.starts_with(arguments.name + "_");
    if (!is_in_the_way) continue;
    throw InputError({ErrorKind::usage, entry.path().string(), "", "would perhaps be replaced, and is not of problem " + arguments.name,
                      "name another folder"});
  }
}

}  // namespace

ExitCode execute(const ProblemWriteArguments& arguments, std::ostream& out) {
  check_folder(arguments);
  if (const auto* curve = problems::find_loading_curve(arguments.name)) {
    const auto file = problems::write(*curve, arguments.directory, arguments.options);
    out << "wrote " << file.string() << "\nnext: jointid loading-curve " << file.string() << ' ' << problems::fit_options(*curve) << '\n';
    return ExitCode::done;
  }
  if (problems::is_coupling(arguments.name)) {
    const auto scene = problems::write(problems::make_coupling(arguments.name), arguments.directory, arguments.options);
    out << "wrote " << scene.string() << "\nnext: jointid couple " << scene.string() << '\n';
    return ExitCode::done;
  }
  if (problems::is_rig_two(arguments.name)) {
    const auto scene = problems::write(problems::make_rig_two(arguments.name), arguments.directory, arguments.options);
    out << "wrote " << scene.string() << "\nnext: jointid equivalent " << scene.string() << " --csv joint.csv\n";
    return ExitCode::done;
  }
  if (problems::is_modal_set(arguments.name)) {
    const auto file = problems::write(problems::make_modal_set(arguments.name), arguments.directory, arguments.options);
    out << "wrote " << file.string() << "\nnext: jointid modalfit " << file.string() << " --real --damping hysteretic\n";
    return ExitCode::done;
  }
  const auto problem = problems::make(arguments.name);
  const auto scene = problems::write(problem, arguments.directory, arguments.options);
  out << "wrote " << scene.string() << "\nnext: jointid solve " << scene.string() << '\n';
  return ExitCode::done;
}

}  // namespace jointid::cli
