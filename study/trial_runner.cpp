#include "study/trial_runner.hpp"

#include "base/statistics.hpp"
#include "ident/identify.hpp"

#include <algorithm>

namespace jointid::study {
namespace {

using SharedSets = std::vector<std::shared_ptr<frf::FrfSet>>;


/// Sources that read `sets` as they are at the time.
std::unique_ptr<frf::FrfSystem> system_on(const char* name, std::vector<frf::FrfSet>& sets, frf::Composition composition,
                                          bool reciprocity) {
  std::vector<std::unique_ptr<frf::FrfSource>> sources;
  for (frf::FrfSet& set : sets) {
    sources.push_back(frf::from_shared(std::shared_ptr<const frf::FrfSet>(std::shared_ptr<void>(), &set)));
  }
  return std::make_unique<frf::FrfSystem>(name, std::move(sources), composition, reciprocity);
}

void restore(const std::vector<frf::FrfSet>& from, std::vector<frf::FrfSet>& to) {
  for (std::size_t i = 0; i < from.size(); ++i) {
    to[i].values = from[i].values;
    to[i].variance = from[i].variance;
    to[i].coherence = from[i].coherence;
  }
}

}  // namespace

struct TrialRunner::State {
  explicit State(std::shared_ptr<const TrialData> shared)
      : data(std::move(shared)), pollution(data->pollution), polluted(data->base) {
    const bool reciprocity = data->scene.data.reciprocity;
    plan = ident::make_plan(data->scene,
                     system_on("substructures", polluted.substructures, frf::Composition::uncoupled, reciprocity),
                     system_on("assembly", polluted.assembly, frf::Composition::merged, reciprocity));
    control.threads = 1;
    control.detail = ident::Detail::estimates;
  }

  std::shared_ptr<const TrialData> data;
  Pollution pollution;
  Measurements polluted;  ///< the plan's sources refer to these sets
  std::unique_ptr<ident::Plan> plan;
  ident::Control control;
};

TrialRunner::TrialRunner(std::shared_ptr<const TrialData> data, std::function<bool()> interrupted)
    : state_(std::make_unique<State>(std::move(data))) {
  state_->control.interrupted = std::move(interrupted);
}
TrialRunner::~TrialRunner() = default;
TrialRunner::TrialRunner(TrialRunner&&) noexcept = default;

const ident::Plan& TrialRunner::plan() const { return *state_->plan; }

const Measurements& TrialRunner::measurements() const { return state_->polluted; }

Trial TrialRunner::run(std::uint64_t seed, std::uint64_t trial) {
  State& at = *state_;
  restore(at.data->base.substructures, at.polluted.substructures);
  restore(at.data->base.assembly, at.polluted.assembly);
  at.pollution(seed, trial, at.polluted);
  const ident::Solution solution = ident::solve(*at.plan, at.control);
  Trial out{.status = solution.status,
            .values = std::vector<double>(at.data->unknowns.size(), nan),
            .ci95 = std::vector<std::optional<std::array<double, 2>>>(at.data->unknowns.size()),
            .quality = {},
            .iterations = solution.fit.iterations,
            .solve_s = solution.runtime_s.total,
            .accumulator_bytes = solution.used.accumulator_bytes};
  for (std::size_t i = 0; i < solution.unknowns.size(); ++i) {
    out.values[i] = solution.unknowns[i].value;
    out.ci95[i] = solution.unknowns[i].ci95;
  }
  for (const restrictions::Kind kind : at.data->judged) {
    const auto found = solution.quality.find(kind);
    out.quality.push_back(found == solution.quality.end() ? ident::Quality{nan, nan, nan} : found->second);
  }
  return out;
}

}  // namespace jointid::study
