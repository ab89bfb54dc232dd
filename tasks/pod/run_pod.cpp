#include "tasks/pod/run_pod.hpp"

#include <algorithm>
#include <cmath>

#include "base/complex.hpp"
#include "base/error.hpp"
#include "dense/eigen.hpp"
#include "oscillation/pod/mode_comparison.hpp"
#include "tasks/tell.hpp"

namespace jointid::tasks {
namespace {

/// The modes that are compared with: of a file, or normal modes of K and M.
Eigen::MatrixXd modes_to_compare(const PodTask& task, const Eigen::MatrixXd& mass, PodResult& out) {
  if (!task.compare.empty()) {
    out.compared = "the modes of --compare";
    return read_pod_matrix(task.compare, out.names.size(), "--compare");
  }
  out.compared = "the normal modes of --stiffness and --mass";
  const Eigen::MatrixXd stiffness = read_pod_matrix(task.stiffness, out.names.size(), "--stiffness");
  if (stiffness.cols() != stiffness.rows() || !stiffness.isApprox(stiffness.transpose(), 1e-9))
    throw InputError({ErrorKind::data, task.stiffness, "", "is not a symmetric matrix", "give the stiffness at the channels"});
  const dense::SymmetricEigen normal = dense::symmetric_eigen(stiffness, mass);
  for (const double square : normal.values) out.frequencies_hz.push_back(hertz(std::sqrt(std::max(square, 0.0))));
  return normal.vectors;
}

}  // namespace

PodResult run_pod(const PodTask& task, PodRecord record) {
  oscillation::PodOptions options;
  options.remove_mean = !task.keep_mean;
  if (!task.mass.empty()) options.mass = read_pod_matrix(task.mass, record.names.size(), "--mass");
  PodResult out{std::move(record.names),
                std::move(record.units),
                record.cut,
                oscillation::pod(record.triangle, options),
                !task.mass.empty(),
                task.keep_mean,
                "",
                {},
                {},
                {},
                {}};
  if (task.compare.empty() && task.stiffness.empty()) return out;
  const Eigen::MatrixXd modes = modes_to_compare(task, options.mass, out);
  out.cosines = oscillation::mode_cosines(out.pod.modes, modes, options.mass);
  out.assurance = oscillation::mode_assurance(out.pod.modes, modes);
  out.contributions = oscillation::mode_contributions(out.pod.modes, modes, options.mass);
  return out;
}

std::optional<PodResult> run_pod(const PodTask& task, ident::Team& team, const ident::Control& control) {
  check(task);
  tell(control, "reading samples");
  const auto read = [&](std::size_t samples) { tell(control, "reading samples", samples); };
  PodRecord record = read_pod_record(task, team, read, control.interrupted);
  if (team.rank() > 0) return std::nullopt;
  return run_pod(task, std::move(record));
}

PodResult run_pod(const PodTask& task, const ident::Control& control) {
  const auto alone = ident::make_team_of_one();
  return *run_pod(task, *alone, control);
}

}  // namespace jointid::tasks
