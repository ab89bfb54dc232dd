#include "ident/frequency_turns.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <string>

#include "base/eigen.hpp"
#include "ident/admissible/eigenfrequencies.hpp"
#include "ident/judgement/tell_errors.hpp"

namespace jointid::ident {
namespace {

/// What turns change of a plan comes back.
class KeptConstraints {
 public:
  explicit KeptConstraints(Plan& plan) : plan_(plan), admissible(plan.admissible), bootstrap(plan.scene.identify.bootstrap) {}
  ~KeptConstraints() {
    plan_.admissible = admissible;
    plan_.scene.identify.bootstrap = bootstrap;
  }
  KeptConstraints(const KeptConstraints&) = delete;
  KeptConstraints& operator=(const KeptConstraints&) = delete;

 private:
  Plan& plan_;

 public:
  const std::shared_ptr<const AdmissibleSet> admissible;
  const std::size_t bootstrap;
};

bool is_empty(const AdmissibleSet& set) { return set.inequalities.empty() && set.ties.empty(); }

Eigen::VectorXd scaled_unknowns(const Plan& plan, const Solution& found) {
  Eigen::VectorXd theta(at(found.unknowns.size()));
  for (std::size_t c = 0; c < found.unknowns.size(); ++c) theta[at(c)] = found.unknowns[c].value / plan.unscale(c);
  return theta;
}

bool stays(const Solution& before, const Solution& now) {
  constexpr double of_error = 1e-3, of_largest = 1e-6;
  std::map<std::string, double> largest;
  for (const Estimate& each : now.unknowns) largest[each.unit] = std::max(largest[each.unit], std::abs(each.value));
  for (std::size_t u = 0; u < now.unknowns.size(); ++u) {
    const Estimate& each = now.unknowns[u];
    const double enough = std::max(of_error * each.std_error.value_or(0.0), of_largest * largest[each.unit]);
    if (!(std::abs(each.value - before.unknowns[u].value) <= enough)) return false;
  }
  return true;
}

}  // namespace

void solve_by_method(Plan& plan, const Control& control, Solution& out) {
  if (plan.scene.identify.frequencies_hz.empty() || !traits(plan.scene.identify.method).iterates)
    return plan.method->solve(plan, control, out);
  constexpr int most = 20;
  const KeptConstraints kept(plan);
  const Eigenfrequencies conditions(plan);
  Control quick = control;
  quick.detail = Detail::estimates;
  quick.judgement = Judgement::none;
  quick.so_far = nullptr;
  plan.scene.identify.bootstrap = 0;
  if (is_empty(*kept.admissible)) plan.admissible = nullptr;
  Solution now = out;
  plan.method->solve(plan, quick, now);
  bool settled = false;
  for (int turn = 0; turn < most && !settled && !now.unknowns.empty(); ++turn) {
    plan.admissible = std::make_shared<const AdmissibleSet>(conditions.tied_at(*kept.admissible, scaled_unknowns(plan, now)));
    Solution next = out;
    plan.method->solve(plan, quick, next);
    settled = !next.unknowns.empty() && stays(now, next);
    now = std::move(next);
  }
  plan.scene.identify.bootstrap = kept.bootstrap;
  plan.method->solve(plan, control, out);
  if (settled || !is_usable(out.status)) return;
  out.status = Status::not_converged;
  out.message += "The motions at the eigenfrequencies that the scene states did not converge.";
}

}  // namespace jointid::ident
