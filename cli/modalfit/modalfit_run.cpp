#include "cli/modalfit/modalfit_run.hpp"

#include "base/stopwatch.hpp"
#include "base/text.hpp"
#include "cli/options/open_options.hpp"
#include "cli/text/interrupt.hpp"
#include "cli/text/progress.hpp"
#include "report/modalfit/modal_run.hpp"

namespace jointid::cli {
namespace {

std::string names(const std::vector<std::filesystem::path>& files) {
  return comma_list(files, [](const auto& file) { return file.filename().string(); });
}

}  // namespace

report::ModalRun run_modalfit(const ModalfitArguments& arguments) {
  Progress progress;
  const auto start = Clock::now();
  const frf::FrfSet set = frf::load(*open_as_one(arguments.files, arguments.open));
  const double read_s = seconds_since(start);
  modalfit::FitOptions options = arguments.fit;
  options.progress = [&progress](const char* stage) { progress.show(stage); };
  options.interrupted = interrupted;
  report::ModalRun run = report::run_modal(names(arguments.files), set, options);
  run.read_s = read_s;
  return run;
}

}  // namespace jointid::cli
