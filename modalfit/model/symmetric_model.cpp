#include "modalfit/model/symmetric_model.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "base/complex.hpp"
#include "base/eigen.hpp"
#include "dense/lu.hpp"
#include "dense/minimum_norm.hpp"
#include "modalfit/band/basis.hpp"
#include "modalfit/model/rank_one.hpp"

namespace jointid::modalfit {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Matrix4 = Eigen::Matrix<double, 4, 4>;
using Vector4 = Eigen::Matrix<double, 4, 1>;

std::vector<frf::Dof> coordinates(const ModalFit& fit) {
  std::vector<frf::Dof> dofs;
  for (const auto* list : {&fit.response, &fit.reference}) {
    for (frf::Dof dof : *list) {
      dof.sign = 1;
      if (!frf::has(dofs, dof)) dofs.push_back(dof);
    }
  }
  std::ranges::sort(dofs, {}, frf::coordinate_key);
  return dofs;
}

/// Where an entry of the fit stands in the symmetric matrix.
struct Place {
  std::size_t row = 0, column = 0;
  double sign = 1.0;
};

std::vector<Place> places(const ModalFit& fit, const std::vector<frf::Dof>& dofs) {
  std::vector<Place> out;
  for (const frf::Dof& response : fit.response) {
    for (const frf::Dof& reference : fit.reference) {
      out.push_back({frf::find_coordinate(dofs, response), frf::find_coordinate(dofs, reference),
                     static_cast<double>(response.sign * reference.sign)});
    }
  }
  return out;
}

std::vector<RankOneDatum> residues_of(const ModalFit& fit, std::size_t mode, const std::vector<Place>& places) {
  const std::size_t own = fit.kind.real_modes ? 1 : 2;
  const double scale = residue_scale(fit.kind, fit.scale_hz);
  std::vector<RankOneDatum> data;
  for (std::size_t e = 0; e < places.size(); ++e) {
    if (fit.residues.freedom[e] <= 0.0) continue;
    const std::size_t first = e * fit.residues.columns + mode * own;
    const double* c = fit.residues.coefficients.data() + first;
    const double* v = fit.residues.variance.data() + first;
    const Complex value = scale * (own == 1 ? Complex(c[0]) : Complex(c[0], c[1]));
    const double variance = scale * scale * (own == 1 ? v[0] : v[0] + v[1]);
    data.push_back({places[e].row, places[e].column, places[e].sign * value, 1.0 / variance});
  }
  return data;
}

/// Residual terms of an entry with the modes held fixed: weighted least squares for Re L, Im L, Re U, Im U.
class ResidualFitter {
 public:
  ResidualFitter(const Basis& basis, const Band& band, const ModelKind& kind, double scale_hz)
      : basis_(basis), band_(band), mode_scale_(residue_scale(kind, scale_hz)),
        lower_scale_(std::pow(angular(scale_hz), 2.0)) {}

  ResidualTerms fit(std::size_t entry, const std::vector<Complex>& residues, double sign) const {
    Matrix4 normal = Matrix4::Zero();
    Vector4 right = Vector4::Zero();
    for (std::size_t line = 0; line < basis_.lines; ++line) {
      const double* weight = band_.weights(entry) + 2 * line;
      const Complex rest = sign * band_.value(entry)[line] - modal_part(residues, line);
      for (std::size_t part = 0; part < 2; ++part) {
        Vector4 row;
        for (std::size_t j = 0; j < 4; ++j) {
          const Complex value = basis_.column(basis_.size() - 4 + j)[line];
          row(at(j)) = weight[part] * (part == 0 ? value.real() : value.imag());
        }
        normal += row * row.transpose();
        right += row * (weight[part] * (part == 0 ? rest.real() : rest.imag()));
      }
    }
    return solved(normal, right);
  }

 private:
  Complex modal_part(const std::vector<Complex>& residues, std::size_t line) const {
    Complex sum = 0.0;
    for (std::size_t r = 0; r < residues.size(); ++r) {
      const std::size_t first = r * basis_.per_mode;
      sum += residues[r].real() / mode_scale_ * basis_.column(first)[line];
      if (basis_.per_mode == 2) sum += residues[r].imag() / mode_scale_ * basis_.column(first + 1)[line];
    }
    return sum;
  }

  ResidualTerms solved(const Matrix4& normal, const Vector4& right) const {
    ResidualTerms out{.lower = {}, .upper = {}, .covariance = {}, .measured = true};
    const Vector4 scale = normal.diagonal().cwiseSqrt().cwiseInverse();
    const Matrix4 scaled = scale.asDiagonal() * normal * scale.asDiagonal();
    const Matrix4 inverse = scale.asDiagonal() * dense::inverse_4x4(scaled) * scale.asDiagonal();
    const Vector4 units(lower_scale_, lower_scale_, 1.0, 1.0);
    const Vector4 x = units.asDiagonal() * (inverse * right);
    out.lower = {x(0), x(1)};
    out.upper = {x(2), x(3)};
    Eigen::Map<Matrix4>(out.covariance.data()) = units.asDiagonal() * inverse * units.asDiagonal();
    return out;
  }

  const Basis& basis_;
  const Band& band_;
  double mode_scale_, lower_scale_;
};

std::vector<Complex> residues_between(const SymmetricModel& model, const Place& place) {
  std::vector<Complex> residues;
  for (const SymmetricMode& mode : model.modes) residues.push_back(mode.shape[place.row] * mode.shape[place.column]);
  return residues;
}

/// Keeps the mean of both where (a,b) and (b,a) were measured.
void put(SymmetricModel& model, const Place& place, const ResidualTerms& terms) {
  const std::size_t n = model.dofs.size();
  ResidualTerms& there = model.residuals[place.row * n + place.column];
  if (there.measured) {
    there.lower = 0.5 * (there.lower + terms.lower);
    there.upper = 0.5 * (there.upper + terms.upper);
    for (std::size_t i = 0; i < 16; ++i) there.covariance[i] = 0.25 * (there.covariance[i] + terms.covariance[i]);
  } else {
    there = terms;
  }
  model.residuals[place.column * n + place.row] = there;
}

void fit_residuals(const ModalFit& fit, const Band& band, const std::vector<Place>& at, SymmetricModel& model) {
  const Basis basis = make_basis(fit.kind, fit.poles(), band.frequency_hz, fit.scale_hz, false);
  const ResidualFitter fitter(basis, band, fit.kind, fit.scale_hz);
  std::vector<ResidualTerms> terms(at.size());
  tbb::parallel_for(std::size_t{0}, at.size(), [&](std::size_t e) {
    if (fit.residues.freedom[e] > 0.0) terms[e] = fitter.fit(e, residues_between(model, at[e]), at[e].sign);
  });
  model.residuals.resize(model.dofs.size() * model.dofs.size());
  for (std::size_t e = 0; e < at.size(); ++e) {
    if (terms[e].measured) put(model, at[e], terms[e]);
  }
}

/// Coordinates whose FRFs to and from all coordinates were measured.
std::vector<std::size_t> complete_columns(const SymmetricModel& model) {
  const std::size_t n = model.dofs.size();
  std::vector<std::size_t> complete;
  for (std::size_t c = 0; c < n; ++c) {
    bool all = true;
    for (std::size_t r = 0; r < n; ++r) all = all && model.residuals[r * n + c].measured;
    if (all) complete.push_back(c);
  }
  return complete;
}

/// X_nr (X_rr)⁺ X_rn of the lower or the upper residuals.
MatrixXcd completed(const SymmetricModel& model, const std::vector<std::size_t>& columns, Complex ResidualTerms::*term) {
  const std::size_t n = model.dofs.size();
  MatrixXcd tall(at(n), at(columns.size())), core(tall.cols(), tall.cols());
  for (std::size_t c = 0; c < columns.size(); ++c) {
    for (std::size_t r = 0; r < n; ++r) tall(at(r), at(c)) = model.residuals[r * n + columns[c]].*term;
    for (std::size_t r = 0; r < columns.size(); ++r) {
      core(at(r), at(c)) = model.residuals[columns[r] * n + columns[c]].*term;
    }
  }
  const dense::ComplexMinimumNorm decomposition(core, 1e-2);  // without directions that noise would blow up
  return tall * decomposition.solve(tall.transpose());
}

void complete_residuals(SymmetricModel& model) {
  const std::size_t n = model.dofs.size();
  const std::vector<std::size_t> columns = complete_columns(model);
  if (columns.empty() || columns.size() == n) return;
  const MatrixXcd lower = completed(model, columns, &ResidualTerms::lower), upper = completed(model, columns, &ResidualTerms::upper);
  for (std::size_t r = 0; r < n; ++r) {
    for (std::size_t c = 0; c < n; ++c) {
      ResidualTerms& terms = model.residuals[r * n + c];
      if (terms.measured) continue;
      terms.lower = lower(at(r), at(c));
      terms.upper = upper(at(r), at(c));
      const auto &of_row = model.residuals[r * n + columns.front()], &of_column = model.residuals[columns.front() * n + c];
      for (std::size_t i = 0; i < 16; ++i) terms.covariance[i] = std::max(of_row.covariance[i], of_column.covariance[i]);
    }
  }
}

std::array<double, 4> pole_block(const ModalFit& fit, std::size_t r) {
  const std::size_t n = 2 * fit.modes.size(), i = 2 * r;
  const auto& c = fit.pole_covariance;
  return {c[i * n + i], c[i * n + i + 1], c[(i + 1) * n + i], c[(i + 1) * n + i + 1]};
}

}  // namespace

std::string obstacle(const ModalFit& fit) {
  for (const frf::Dof& dof : fit.reference) {
    if (frf::has(fit.response, dof)) return {};
  }
  return "no coordinate is both response and reference: without a driving point the mode shapes have no scale";
}

SymmetricModel make_symmetric(const ModalFit& fit, const Band& band) {
  SymmetricModel model;
  model.kind = fit.kind;
  model.dofs = coordinates(fit);
  model.scale_hz = fit.scale_hz;
  model.range_hz = {band.frequency_hz.front(), band.frequency_hz.back()};
  const std::vector<Place> at = places(fit, model.dofs);
  for (std::size_t r = 0; r < fit.modes.size(); ++r) {
    RankOne one = fit_rank_one(residues_of(fit, r, at), model.dofs.size(), fit.kind.real_modes);
    model.modes.push_back({fit.modes[r].pole, std::move(one.vector), std::move(one.covariance), pole_block(fit, r), one.misfit});
  }
  fit_residuals(fit, band, at, model);
  complete_residuals(model);
  return model;
}

}  // namespace jointid::modalfit
