#include "cli/loading_curve/loading_curve_command.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <stdexcept>

#include "base/error.hpp"
#include "cli/loading_curve/loading_curve_page.hpp"
#include "cli/loading_curve/loading_curve_report.hpp"
#include "cli/options/command_options.hpp"
#include "cli/options/output.hpp"
#include "cli/text/failure.hpp"
#include "cli/text/interrupt.hpp"
#include "cli/text/progress.hpp"
#include "friction/law/laws.hpp"
#include "ident/identify.hpp"

namespace jointid::cli {
namespace {

using friction::Fit;

friction::Minimiser minimiser(const std::string& word) {
  if (word == "pattern") return friction::Minimiser::pattern;
  return word == "ceres" ? friction::Minimiser::ceres : friction::Minimiser::best;
}

std::vector<std::string> laws(const LoadingCurveArguments& arguments) {
  const bool all = arguments.laws.empty() || std::ranges::find(arguments.laws, "all") != arguments.laws.end();
  std::vector<std::string> chosen = all ? friction::fitted_laws() : arguments.laws;
  const bool ties = arguments.limit || arguments.friction_coefficient;
  if (all && ties) std::erase_if(chosen, [](const std::string& law) { return !friction::law(law).has_limit; });
  return chosen;
}

friction::FitOptions options(const LoadingCurveArguments& arguments) {
  friction::FitOptions out;
  out.weighting = friction::parse_weighting(arguments.weighting);
  out.minimiser = minimiser(arguments.minimiser);
  out.global = arguments.global;
  out.limit = arguments.limit;
  out.friction_coefficient = arguments.friction_coefficient;
  out.shared = arguments.shared;
  return out;
}

friction::Family family(const LoadingCurveArguments& arguments, const std::string& law) {
  if (arguments.ring.empty()) return friction::family(law);
  return friction::ring_family(law, arguments.ring[0], arguments.ring[1]);
}

/// All loops of a record are of one joint.
void share_all(const std::string& law, friction::FitOptions& options) {
  options.shared.clear();
  for (const auto& parameter : friction::law(law).parameters) options.shared.emplace_back(parameter.name);
}

class Fitting {
 public:
  Fitting(const LoadingCurveArguments& arguments, SoFar<LoadingCurveReport>& done)
      : arguments_(arguments), options_(options(arguments)), done_(done) {}

  LoadingCurveReport run() {
    LoadingCurveReport report;
    for (const auto& file : arguments_.files) report.title += (report.title.empty() ? "" : ", ") + file.filename().string();
    report.data = read_curves(arguments_);
    const bool several_loops = report.data.loops && report.data.curves.size() > 1;
    if (several_loops && options_.friction_coefficient) {
      throw InputError({ErrorKind::usage, "", "--friction-coefficient", "is for loading curves, not for loops",
                        "leave it out: with --normal-load the coefficient of every limit is printed"});
    }
    for (const std::string& law : laws(arguments_)) {
      report.fits.push_back(together(report.data.curves, law, several_loops));
      best_first(report.fits);
      done_.put(report);
    }
    if (!several_loops) return report;
    for (const Fit& fit : report.fits) report.of_loops.push_back(one_by_one(report.data.curves, fit.law));
    return report;
  }

 private:
  static void best_first(std::vector<Fit>& fits) {
    std::ranges::stable_sort(fits, {}, [](const Fit& fit) { return std::pair(fit.status != friction::FitStatus::usable, fit.aic); });
  }

  static void stop_when_asked() {
    if (interrupted()) throw Interrupted();
  }

  Fit together(const std::vector<friction::Curve>& curves, const std::string& law, bool share) {
    stop_when_asked();
    progress_.show("fitting " + law);
    friction::FitOptions of_law = options_;
    if (share) share_all(law, of_law);
    return friction::fit(curves, family(arguments_, law), of_law);
  }

  std::vector<Fit> one_by_one(const std::vector<friction::Curve>& curves, const std::string& law) {
    std::vector<Fit> fits;
    for (const friction::Curve& curve : curves) {
      stop_when_asked();
      progress_.show("fitting " + law + " to " + curve.name);
      fits.push_back(friction::fit(std::span(&curve, 1), family(arguments_, law), options_));
    }
    return fits;
  }

  const LoadingCurveArguments& arguments_;
  friction::FitOptions options_;
  SoFar<LoadingCurveReport>& done_;
  Progress progress_;
};

void write(const LoadingCurveArguments& arguments, const LoadingCurveReport& report, std::ostream& out) {
  if (arguments.json) write_target(*arguments.json, loading_curve_json(report), out);
  if (arguments.csv) write_target(*arguments.csv, loading_curve_csv(report), out);
  if (arguments.report) write_target(*arguments.report, report::loading_curve_report(report), out);
  if (!takes_output({arguments.json, arguments.csv, arguments.report})) out << loading_curve_text(report);
}

/// Writes the laws that were fitted when the command was interrupted.
std::string save(const LoadingCurveArguments& arguments, std::optional<LoadingCurveReport> done, std::ostream& out) {
  if (!done) return "interrupted";
  done->data.notes.push_back("INTERRUPTED: only the laws that were fitted so far");
  write(arguments, *done, out);
  return "interrupted; the laws that were fitted so far are written";
}

LoadingCurveReport fitted(const LoadingCurveArguments& arguments, std::ostream& out) {
  SoFar<LoadingCurveReport> done;
  try {
    return with_last_words([&] { return save(arguments, done.get(), out); }, [&] { return Fitting(arguments, done).run(); });
  } catch (const std::invalid_argument& error) {
    throw InputError({ErrorKind::usage, "", "loading-curve", error.what(), "change the options"});
  }
}

}  // namespace

void add_loading_curve(CLI::App& app, Chosen& chosen) {
  auto [command, arguments] =
      add_command<LoadingCurveArguments>(app, chosen, "loading-curve", "Find the law of a friction joint from measured curves");
  declare(*command, *arguments);
}

ExitCode execute(const LoadingCurveArguments& arguments, std::ostream& out) {
  check(arguments);
  const LoadingCurveReport report = fitted(arguments, out);
  write(arguments, report, out);
  if (some_usable(report)) return ExitCode::done;
  print_error(report.title + ": " + report.fits.front().message);
  return ExitCode::unusable;
}

}  // namespace jointid::cli
