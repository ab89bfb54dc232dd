#include "cli/commands.hpp"
#include "cli/frf_summary.hpp"
#include "cli/interrupt.hpp"

namespace jointid::cli {

ExitCode execute(const InfoArguments& arguments, std::ostream& out) {
  catch_interrupts();
  const auto source = frf::open(arguments.file, arguments.open);
  const FrfCensus census = take_census(*source, interrupted);
  out << arguments.file.string() << '\n' << summary_text(source->header(), census);
  return census.complete ? ExitCode::done : ExitCode::interrupted;
}

}  // namespace jointid::cli
