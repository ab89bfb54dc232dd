#include "response/structure/frf_receptance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <string>

#include "base/eigen.hpp"
#include "base/error.hpp"

namespace jointid::response {
namespace {

constexpr double same_line = 1e-3;  ///< of the spacing: two frequencies nearer than that are one line

/// DOFs without repeats, and the sums of them that rows or columns are: joints first, then single DOFs.
struct Combination {
  std::vector<frf::Dof> dofs;
  Eigen::MatrixXd weights;  ///< [dof, row or column]
};

std::size_t place_of(std::vector<frf::Dof>& dofs, const frf::Dof& dof) {
  const auto found = std::ranges::find(dofs, dof);
  if (found != dofs.end()) return static_cast<std::size_t>(found - dofs.begin());
  dofs.push_back(dof);
  return dofs.size() - 1;
}

Combination combination(const std::vector<JointEnds>& joints, const std::vector<frf::Dof>& single) {
  Combination all;
  struct Entry {
    std::size_t dof, column;
    double weight;
  };
  std::vector<Entry> entries;
  std::size_t column = 0;
  for (const JointEnds& joint : joints) {
    entries.push_back({place_of(all.dofs, joint.positive), column, 1.0});
    if (joint.negative) entries.push_back({place_of(all.dofs, *joint.negative), column, -1.0});
    ++column;
  }
  for (const frf::Dof& dof : single) entries.push_back({place_of(all.dofs, dof), column++, 1.0});
  all.weights.setZero(jointid::at(all.dofs.size()), jointid::at(column));
  for (const Entry& entry : entries) all.weights(jointid::at(entry.dof), jointid::at(entry.column)) += entry.weight;
  return all;
}

[[noreturn]] void fail(const frf::FrfSystem& parts, std::string place, std::string problem, std::string remedy) {
  throw InputError({.kind = ErrorKind::data,
                    .file = parts.name(),
                    .place = std::move(place),
                    .problem = std::move(problem),
                    .remedy = std::move(remedy)});
}

void require_measured(const frf::FrfSystem& parts, const std::vector<frf::Dof>& wanted, const std::vector<frf::Dof>& measured,
                      const std::string& role) {
  for (const frf::Dof& dof : wanted) {
    if (frf::has(measured, dof)) continue;
    const std::string nearest = nearest_word(dof.name(), frf::names(measured));
    fail(parts, role + " " + dof.name(), "no file has it", nearest.empty() ? "" : "did you mean " + nearest + "?");
  }
}

}  // namespace

FrfReceptance::FrfReceptance(frf::FrfSystem& parts, const std::vector<JointEnds>& joints, const std::vector<frf::Dof>& responses,
                             const std::vector<frf::Dof>& forces)
    : joints_(jointid::at(joints.size())),
      responses_(jointid::at(responses.size())),
      forces_(jointid::at(forces.size())),
      frequency_hz_(parts.frequency_hz()) {
  const Combination rows = combination(joints, responses), columns = combination(joints, forces);
  require_measured(parts, rows.dofs, parts.responses(), "response");
  require_measured(parts, columns.dofs, parts.references(), "reference");
  frf::BlockReader reader(parts, rows.dofs, columns.dofs);
  RowMatrixXc block(jointid::at(rows.dofs.size()), jointid::at(columns.dofs.size()));
  const std::span<Complex> values(block.data(), static_cast<std::size_t>(block.size()));
  for (std::size_t line = 0; line < frequency_hz_.size(); ++line) {
    reader.read(std::span(&line, 1), values);
    if (!block.allFinite()) {
      fail(parts, std::to_string(frequency_hz_[line]) + " Hz",
           "an FRF between a joint, response or force coordinate is not measured",
           "measure the joint's rows and columns of every part, or leave the line out");
    }
    lines_.emplace_back(rows.weights.transpose() * block * columns.weights);
  }
}

std::size_t FrfReceptance::nearest_line(double omega) const {
  const double hz = omega / (2.0 * std::numbers::pi);
  const auto above = std::ranges::lower_bound(frequency_hz_, hz);
  if (above == frequency_hz_.begin()) return 0;
  if (above == frequency_hz_.end()) return frequency_hz_.size() - 1;
  const std::size_t line = static_cast<std::size_t>(above - frequency_hz_.begin());
  return hz - frequency_hz_[line - 1] < frequency_hz_[line] - hz ? line - 1 : line;
}

double FrfReceptance::nearest(double omega) const { return angular(frequency_hz_[nearest_line(omega)]); }

bool FrfReceptance::covers(double omega) const {
  const std::size_t line = nearest_line(omega);
  const double hz = omega / (2.0 * std::numbers::pi);
  double spacing = std::numeric_limits<double>::infinity();
  if (line > 0) spacing = std::min(spacing, frequency_hz_[line] - frequency_hz_[line - 1]);
  if (line + 1 < frequency_hz_.size()) spacing = std::min(spacing, frequency_hz_[line + 1] - frequency_hz_[line]);
  return std::abs(frequency_hz_[line] - hz) <= same_line * std::min(spacing, hz) + 1e-9 * hz;
}

Eigen::MatrixXcd FrfReceptance::at(double omega) const {
  if (covers(omega)) return lines_[nearest_line(omega)];
  const std::size_t line = nearest_line(omega);
  throw InputError({.kind = ErrorKind::data,
                    .file = "",
                    .place = std::to_string(omega / (2.0 * std::numbers::pi)) + " Hz",
                    .problem = "the FRFs have no line there; the nearest is at " + std::to_string(frequency_hz_[line]) + " Hz",
                    .remedy = "choose lines whose multiples are lines, or regenerate the FRFs by `modalfit`"});
}

}  // namespace jointid::response
