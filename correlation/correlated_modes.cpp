#include "correlation/correlated_modes.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "correlation/common_places.hpp"
#include "correlation/criteria.hpp"

namespace jointid::correlation {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;

std::vector<double> frequencies_of(const ModeFile& of) {
  std::vector<double> out;
  for (const frf::Uff55Mode& mode : of.modes) out.push_back(mode.frequency_hz);
  return out;
}

}  // namespace

std::size_t CorrelatedModes::pairs() const {
  return static_cast<std::size_t>(std::ranges::count_if(partner, [](const auto& each) { return each.has_value(); }));
}

std::vector<frf::Dof> dofs_of_all(const ModeFile& of) {
  if (of.modes.empty())
    throw InputError({.kind = ErrorKind::data,
                      .file = of.file,
                      .place = "modes",
                      .problem = "there is none",
                      .remedy = "name a universal file with mode shapes (dataset 55)"});
  std::vector<frf::Dof> out = of.modes.front().dofs;
  std::erase_if(out, [&](const frf::Dof& dof) {
    return std::ranges::any_of(of.modes, [&](const frf::Uff55Mode& mode) { return !frf::has(mode.dofs, dof); });
  });
  const MatrixXcd shapes = shapes_at(of.modes, out);
  for (Index i = shapes.rows(); i-- > 0;) {
    if (shapes.row(i).isZero(0.0)) out.erase(out.begin() + i);
  }
  return out;
}

MatrixXcd shapes_at(const std::vector<frf::Uff55Mode>& modes, const std::vector<frf::Dof>& dofs) {
  MatrixXcd out(static_cast<Index>(dofs.size()), static_cast<Index>(modes.size()));
  for (std::size_t r = 0; r < modes.size(); ++r) {
    for (const Match& each : common_dofs(dofs, modes[r].dofs))
      out(static_cast<Index>(each.one), static_cast<Index>(r)) = each.sign * modes[r].shape[each.other];
  }
  return out;
}

CorrelatedModes correlate(const ModeFile& one, const ModeFile& other) {
  const std::vector<frf::Dof> first = dofs_of_all(one), second = dofs_of_all(other);
  CorrelatedModes out;
  out.one_hz = frequencies_of(one);
  out.other_hz = frequencies_of(other);
  for (const Match& each : common_dofs(first, second)) out.dofs.push_back(first[each.one]);
  if (out.dofs.empty()) fail_nothing_common(one.file, other.file, "coordinates of modes", some_names(first), some_names(second));
  const MatrixXcd a = shapes_at(one.modes, out.dofs), b = shapes_at(other.modes, out.dofs);
  constexpr double alike = 0.5;
  out.mac = mac_matrix(a, b);
  out.partner = paired(out.mac, alike);
  std::vector<Index> of_one, of_other;
  for (std::size_t r = 0; r < out.partner.size(); ++r) {
    if (!out.partner[r]) continue;
    of_one.push_back(static_cast<Index>(r));
    of_other.push_back(static_cast<Index>(*out.partner[r]));
  }
  if (of_one.empty()) return out;
  out.comac = comac(a(Eigen::all, of_one).colwise().normalized(), b(Eigen::all, of_other).colwise().normalized());
  out.ecomac = ecomac(a(Eigen::all, of_one), b(Eigen::all, of_other));
  return out;
}

}  // namespace jointid::correlation
