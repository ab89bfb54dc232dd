#include "response/structure/frf_receptance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include "base/complex.hpp"
#include "base/eigen.hpp"
#include "base/error.hpp"
#include "response/structure/frf_variances.hpp"

namespace jointid::response {
namespace {

constexpr double same_line = 1e-3;  ///< of the spacing: two frequencies nearer than that are one line

std::size_t place_of(std::vector<frf::Dof>& dofs, const frf::Dof& dof) {
  const auto found = std::ranges::find(dofs, dof);
  if (found != dofs.end()) return static_cast<std::size_t>(found - dofs.begin());
  dofs.push_back(dof);
  return dofs.size() - 1;
}

FrfCombination combination(const std::vector<JointEnds>& joints, const std::vector<frf::Dof>& single) {
  FrfCombination all;
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

/// For each FRF of the rectangle, by column, the place of its transpose, or −1.
std::vector<Eigen::Index> transposes(const std::vector<frf::Dof>& rows, const std::vector<frf::Dof>& columns) {
  std::vector<Eigen::Index> places;
  for (const frf::Dof& column : columns) {
    for (const frf::Dof& row : rows) {
      const std::size_t i = frf::find_coordinate(rows, column), j = frf::find_coordinate(columns, row);
      const bool there = i != frf::npos && j != frf::npos && !row.same_coordinate(column);
      places.push_back(there ? jointid::at(j * rows.size() + i) : -1);
    }
  }
  return places;
}

}  // namespace

FrfReceptance::FrfReceptance(frf::FrfSystem& parts, const std::vector<JointEnds>& joints, const std::vector<frf::Dof>& responses,
                             const std::vector<frf::Dof>& forces)
    : joints_(jointid::at(joints.size())),
      responses_(jointid::at(responses.size())),
      forces_(jointid::at(forces.size())),
      frequency_hz_(parts.frequency_hz()) {
  rows_ = combination(joints, responses);
  columns_ = combination(joints, forces);
  require_measured(parts, rows_.dofs, parts.responses(), "response");
  require_measured(parts, columns_.dofs, parts.references(), "reference");
  frf::BlockReader reader(parts, rows_.dofs, columns_.dofs);
  RowMatrixXc block(jointid::at(rows_.dofs.size()), jointid::at(columns_.dofs.size()));
  const std::span<Complex> values(block.data(), static_cast<std::size_t>(block.size()));
  twin_ = transposes(rows_.dofs, columns_.dofs);
  for (std::size_t line = 0; line < frequency_hz_.size(); ++line) {
    reader.read(std::span(&line, 1), values);
    if (!block.allFinite()) {
      fail(parts, std::to_string(frequency_hz_[line]) + " Hz",
           "an FRF between a joint, response or force coordinate is not measured",
           "measure the joint's rows and columns of every part, or leave the line out");
    }
    lines_.emplace_back(rows_.weights.transpose() * block * columns_.weights);
    const Eigen::MatrixXcd& by_column = measured_.emplace_back(block);
    for (Eigen::Index i = 0; i < by_column.size(); ++i) {
      Eigen::Index& twin = twin_[static_cast<std::size_t>(i)];
      if (twin >= 0 && by_column(i) != by_column(twin)) twin = -1;
    }
  }
  variances_ = read_variances(parts, rows_.dofs, columns_.dofs);
}

std::vector<ReceptanceError> FrfReceptance::errors(double omega) const {
  std::vector<ReceptanceError> all;
  if (variances_.empty() || !covers(omega)) return all;
  const Eigen::MatrixXcd& variance = variances_[nearest_line(omega)];
  const auto shape = [&](Eigen::Index place) -> Eigen::MatrixXd {
    const Eigen::Index row = place % variance.rows(), column = place / variance.rows();
    return rows_.weights.row(row).transpose() * columns_.weights.row(column);
  };
  for (Eigen::Index i = 0; i < variance.size(); ++i) {
    const Eigen::Index twin = twin_[static_cast<std::size_t>(i)];
    if (variance(i) == Complex(0.0) || (twin >= 0 && twin < i)) continue;
    all.push_back({shape(i), variance(i)});
    if (twin > i) all.back().shape += shape(twin);
  }
  return all;
}

std::size_t FrfReceptance::nearest_line(double omega) const {
  const double hz = hertz(omega);
  const auto above = std::ranges::lower_bound(frequency_hz_, hz);
  if (above == frequency_hz_.begin()) return 0;
  if (above == frequency_hz_.end()) return frequency_hz_.size() - 1;
  const std::size_t line = static_cast<std::size_t>(above - frequency_hz_.begin());
  return hz - frequency_hz_[line - 1] < frequency_hz_[line] - hz ? line - 1 : line;
}

double FrfReceptance::nearest(double omega) const { return angular(frequency_hz_[nearest_line(omega)]); }

bool FrfReceptance::covers(double omega) const {
  const std::size_t line = nearest_line(omega);
  const double hz = hertz(omega);
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
                    .place = std::to_string(hertz(omega)) + " Hz",
                    .problem = "the FRFs have no line there; the nearest is at " + std::to_string(frequency_hz_[line]) + " Hz",
                    .remedy = "choose lines whose multiples are lines, or regenerate the FRFs by `modalfit`"});
}

}  // namespace jointid::response
