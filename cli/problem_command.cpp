#include "cli/commands.hpp"
#include "cli/interrupt.hpp"
#include "cli/table.hpp"
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

ExitCode execute(const ProblemWriteArguments& arguments, std::ostream& out) {
  catch_interrupts();  // a file that is being written is finished
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
