#include "tasks/loading_curve/loading_curve_fit.hpp"

#include <algorithm>
#include <span>

#include "base/control.hpp"
#include "base/error.hpp"
#include "base/text.hpp"
#include "friction/fit/fit_start.hpp"
#include "friction/law/laws.hpp"

namespace jointid::tasks {
namespace {

using friction::Fit;

friction::Minimiser minimiser(const std::string& word) {
  if (word == "pattern") return friction::Minimiser::pattern;
  return word == "ceres" ? friction::Minimiser::ceres : friction::Minimiser::best;
}

std::vector<std::string> laws(const LoadingCurveTask& task) {
  const bool all = task.laws.empty() || std::ranges::find(task.laws, "all") != task.laws.end();
  std::vector<std::string> chosen = all ? friction::fitted_laws() : task.laws;
  const bool ties = task.limit || task.friction_coefficient;
  if (all && ties) std::erase_if(chosen, [](const std::string& law) { return !friction::law(law).has_limit; });
  return chosen;
}

friction::FitOptions options(const LoadingCurveTask& task) {
  friction::FitOptions out;
  out.weighting = friction::parse_weighting(task.weighting);
  out.minimiser = minimiser(task.minimiser);
  out.limit = task.limit;
  out.friction_coefficient = task.friction_coefficient;
  out.shared = task.shared;
  return out;
}

friction::Family family(const LoadingCurveTask& task, const std::string& law) {
  if (task.ring.empty()) return friction::family(law);
  return friction::ring_family(law, task.ring[0], task.ring[1]);
}

/// All loops of a record are of one joint.
void share_all(const std::string& law, friction::FitOptions& options) {
  options.shared.clear();
  for (const auto& parameter : friction::law(law).parameters) options.shared.emplace_back(parameter.name);
}

class Fitting {
 public:
  Fitting(const LoadingCurveTask& task, const FittingWatch& watch) : task_(task), options_(options(task)), watch_(watch) {
    options_.interrupted = watch.interrupted;
  }

  LoadingCurveResult run(LoadingCurveResult result) {
    const bool several_loops = result.data.loops && result.data.curves.size() > 1;
    if (several_loops && options_.friction_coefficient) {
      throw InputError({ErrorKind::usage, "", "--friction-coefficient", "is for loading curves, not for loops",
                        "leave it out: with --normal-load the coefficient of every limit is printed"});
    }
    if (task_.slopes) {
      for (const friction::Curve& curve : result.data.curves)
        result.slopes.push_back(friction::slip_shares(curve, {.points = *task_.slopes}));
    }
    for (const std::string& law : laws(task_)) {
      result.fits.push_back(together(result.data.curves, law, several_loops));
      best_first(result.fits);
      if (watch_.so_far) watch_.so_far(result);
    }
    if (!several_loops) return result;
    for (const Fit& fit : result.fits) result.of_loops.push_back(one_by_one(result.data.curves, fit.law));
    return result;
  }

 private:
  static void best_first(std::vector<Fit>& fits) {
    std::ranges::stable_sort(fits, {},
                             [](const Fit& fit) { return std::pair(fit.status != Status::ok, fit.aic); });
  }

  void begin(const std::string& stage) const {
    stop_if(watch_.interrupted);
    if (watch_.progress) watch_.progress(stage);
  }

  Fit together(const std::vector<friction::Curve>& curves, const std::string& law, bool share) {
    begin("fitting " + law);
    friction::FitOptions of_law = options_;
    if (share) share_all(law, of_law);
    return friction::fit(curves, family(task_, law), of_law);
  }

  std::vector<Fit> one_by_one(const std::vector<friction::Curve>& curves, const std::string& law) {
    std::vector<Fit> fits;
    for (const friction::Curve& curve : curves) {
      begin("fitting " + law + " to " + curve.name);
      fits.push_back(friction::fit(std::span(&curve, 1), family(task_, law), options_));
    }
    return fits;
  }

  const LoadingCurveTask& task_;
  friction::FitOptions options_;
  const FittingWatch& watch_;
};

/// Turns what the library throws about options into an error of the task.
template <class Act>
auto with_usage_errors(Act&& act) {
  try {
    return act();
  } catch (const InputError& error) {
    if (!error.parts().place.empty() || !error.parts().file.empty()) throw;
    const std::string& remedy = error.parts().remedy;
    throw InputError({ErrorKind::usage, "", "loading-curve", error.parts().problem, remedy.empty() ? "change the options" : remedy});
  }
}

}  // namespace

LoadingCurveResult fit_loading_curves(const LoadingCurveTask& task, const FittingWatch& watch) {
  return with_usage_errors([&] {
    Fitting fitting(task, watch);
    return fitting.run(
        {comma_list(task.files, [](const auto& file) { return file.filename().string(); }), read_curves(task), {}, {}, {}});
  });
}

LoadingCurveResult fit_loading_curves(LoadingCurveData data, const LoadingCurveTask& task, const FittingWatch& watch) {
  if (data.curves.empty()) throw InputError({ErrorKind::usage, "", "loading-curve", "there is no curve", "give one or more"});
  return with_usage_errors([&] {
    std::ranges::for_each(data.curves, friction::validate);
    return Fitting(task, watch).run({"", std::move(data), {}, {}, {}});
  });
}

}  // namespace jointid::tasks
