#include "tasks/export/exported_joint.hpp"

#include <cmath>
#include <limits>
#include <set>

#include "base/error.hpp"
#include "base/temporary_file.hpp"
#include "ident/identify.hpp"
#include "ident/likelihood/findings/joint_errors.hpp"
#include "ident/scene/read_scene.hpp"
#include "tasks/export/joint_of_result.hpp"
#include "tasks/json_file.hpp"

namespace jointid::tasks {
namespace {

constexpr double unknown_error = std::numeric_limits<double>::quiet_NaN();

/// Covariance of the columns with the standard errors of the solution, and the correlations that the likelihood has where it
/// gives them.
ident::Matrix covariance_of_columns(const ident::Plan& plan, const ident::Solution& solution, const ident::Control& control) {
  const std::size_t p = solution.unknowns.size();
  ident::Matrix out(p, std::vector<double>(p, unknown_error));
  for (std::size_t c = 0; c < p; ++c) {
    if (const auto error = solution.unknowns[c].error()) out[c][c] = *error * *error;
  }
  if (solution.used.method != ident::Method::likelihood) return out;
  try {
    std::vector<double> values;
    for (const ident::Estimate& unknown : solution.unknowns) values.push_back(unknown.value);
    const Eigen::MatrixXd found = ident::joint_errors(plan, values, control).covariance;
    for (std::size_t i = 0; i < p; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const auto a = static_cast<Eigen::Index>(i), b = static_cast<Eigen::Index>(j);
        out[i][j] = out[j][i] = found(a, b) / std::sqrt(found(a, a) * found(b, b)) * std::sqrt(out[i][i] * out[j][j]);
      }
    }
  } catch (const InputError&) {  // bands, bounds, gains: only the variances are known
  }
  return out;
}

/// σ² = Σ c_s c_t C_st over the unknowns of each element; those whose covariance is not known count as independent only when
/// alone.
void state_element_errors(const ident::Plan& plan, double inside_hz, ExportedJoint& out) {
  const std::vector<std::size_t> columns = plan.columns->at(inside_hz);
  const std::size_t n = out.dofs.size();
  for (const restrictions::MatrixTerms& matrix : plan.restriction.matrices) {
    ident::Matrix& errors = out.errors[matrix.kind];
    errors.assign(n, std::vector<double>(n, 0.0));
    for (const restrictions::Term& first : matrix.terms) {
      for (const restrictions::Term& second : matrix.terms) {
        if (first.row != second.row || first.column != second.column) continue;
        errors[first.row][first.column] +=
            first.coefficient * second.coefficient * out.covariance[columns[first.unknown]][columns[second.unknown]];
      }
    }
    for (std::vector<double>& row : errors) {
      for (double& error : row) error = std::sqrt(error);
    }
  }
}

ExportedJoint joint_of_scene(const std::filesystem::path& file, std::size_t band, const ident::Control& control) {
  const auto plan = ident::make_plan(ident::read_scene(file));
  const ident::Solution solution = ident::solve(*plan, control);
  const std::size_t count = solution.bands.size();
  if ((band == 0 && count > 1) || band > count) refuse_band(file, band, count);
  const ident::BandMatrices& of = solution.bands[band == 0 ? 0 : band - 1];
  ExportedJoint out{.source = file.string(),
                    .status = ident::name(solution.status),
                    .dofs = solution.dofs,
                    .matrices = of.matrices,
                    .errors = {},
                    .unknowns = solution.unknowns,
                    .covariance = covariance_of_columns(*plan, solution, control)};
  state_element_errors(*plan, of.band_hz ? 0.5 * ((*of.band_hz)[0] + (*of.band_hz)[1]) : 0.0, out);
  return out;
}

void require_usable(const ExportedJoint& joint) {
  const auto fail = [&](const std::string& problem, const std::string& remedy) {
    throw InputError({.kind = ErrorKind::data, .file = joint.source, .place = "status", .problem = problem, .remedy = remedy});
  };
  static const std::set<std::string> usable = {ident::name(ident::Status::ok), ident::name(ident::Status::doubtful)};
  if (!usable.contains(joint.status))
    fail("the joint is not usable: " + joint.status, "`jointid solve` gives the reason; a joint that is not known is not exported");
  for (const auto& [kind, rows] : joint.matrices) {
    for (const std::vector<double>& row : rows) {
      for (const double value : row) {
        if (!std::isfinite(value)) fail(restrictions::key(kind) + " has an element that is no number", "see `jointid solve`");
      }
    }
  }
  for (const frf::Dof& dof : joint.dofs) {
    if (dof.node < 1)
      fail("'" + dof.name() + "' has no node number of a mesh",
           "name the nodes as the finite-element model: [data.files] rename");
  }
}

void turn_to_positive(ExportedJoint& joint) {
  for (std::size_t i = 0; i < joint.dofs.size(); ++i) {
    if (joint.dofs[i].sign > 0) continue;
    joint.dofs[i].sign = +1;
    for (auto& [kind, rows] : joint.matrices) {
      for (std::size_t j = 0; j < joint.dofs.size(); ++j) {
        rows[i][j] = -rows[i][j];
        rows[j][i] = -rows[j][i];
      }
    }
  }
}

}  // namespace

bool is_result_file(const std::filesystem::path& file) {
  require_regular_file(file, ErrorKind::usage);
  return is_json_file(file);
}

ExportedJoint exported_joint(const std::filesystem::path& scene_or_result, std::size_t band, const ident::Control& control) {
  ExportedJoint joint =
      is_result_file(scene_or_result) ? joint_of_result(scene_or_result, band) : joint_of_scene(scene_or_result, band, control);
  require_usable(joint);
  turn_to_positive(joint);
  return joint;
}

}  // namespace jointid::tasks
