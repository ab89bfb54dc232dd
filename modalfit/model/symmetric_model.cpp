#include "modalfit/model/symmetric_model.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "base/complex.hpp"
#include "base/eigen.hpp"
#include "dense/lu.hpp"
#include "modalfit/band/basis.hpp"
#include "modalfit/model/rank_one.hpp"

namespace jointid::modalfit {
namespace {

using Matrix4 = Eigen::Matrix<double, 4, 4>;
using Vector4 = Eigen::Matrix<double, 4, 1>;

std::vector<frf::Dof> coordinates(const ModalFit& fit) {
  std::vector<frf::Dof> dofs;
  for (const auto* list : {&fit.response, &fit.reference}) {
    for (frf::Dof dof : *list) {
      dof.sign = 1;
      dofs.push_back(dof);
    }
  }
  std::ranges::sort(dofs, {}, frf::coordinate_key);
  dofs.erase(std::unique(dofs.begin(), dofs.end()), dofs.end());
  return dofs;
}

/// Where an entry of the fit stands in the symmetric matrix.
struct Place {
  std::size_t row = 0, column = 0;
  double sign = 1.0;
};

std::vector<Place> places(const ModalFit& fit, const SymmetricModel& model) {
  std::vector<std::size_t> columns;
  for (const frf::Dof& reference : fit.reference) columns.push_back(model.find(reference));
  std::vector<Place> out;
  for (const frf::Dof& response : fit.response) {
    const std::size_t row = model.find(response);
    for (std::size_t c = 0; c < columns.size(); ++c) {
      out.push_back({row, columns[c], static_cast<double>(response.sign * fit.reference[c].sign)});
    }
  }
  return out;
}

/// The core is the same for all modes: coordinates of the references, or of the responses where those are fewer.
Core core_of(const std::vector<Place>& places, std::size_t size) {
  std::vector<RankOneDatum> data;
  for (const Place& place : places) data.push_back({.row = place.row, .column = place.column, .value = {}, .weight = 0.0});
  return core_of(data, size);
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

/// Residual terms of an entry with the modes held fixed: weighted least squares for Re L, Im L, Re U, Im U, in `unit`.
class ResidualFitter {
 public:
  ResidualFitter(const Basis& basis, const Band& band, const ModelKind& kind, double scale_hz, double unit)
      : basis_(basis), band_(band), unit_(unit), mode_scale_(residue_scale(kind, scale_hz)),
        lower_scale_(std::pow(angular(scale_hz), 2.0)) {}

  ResidualTerms fit(std::size_t entry, const std::vector<Complex>& residues, double sign) const {
    Matrix4 normal = Matrix4::Zero();
    Vector4 right = Vector4::Zero();
    for (std::size_t line = 0; line < basis_.lines; ++line) {
      const double* weight = band_.weights(entry) + 2 * line;
      const Complex rest = sign / unit_ * band_.value(entry)[line] - modal_part(residues, line);
      for (std::size_t part = 0; part < 2; ++part) {
        const double own_weight = weight[part] * unit_;
        Vector4 row;
        for (std::size_t j = 0; j < 4; ++j) {
          const Complex value = basis_.column(basis_.size() - 4 + j)[line];
          row(at(j)) = own_weight * (part == 0 ? value.real() : value.imag());
        }
        normal += row * row.transpose();
        right += row * (own_weight * (part == 0 ? rest.real() : rest.imag()));
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
  double unit_, mode_scale_, lower_scale_;
};

std::vector<Complex> residues_between(const SymmetricModel& model, const Place& place) {
  std::vector<Complex> residues;
  for (const SymmetricMode& mode : model.modes) residues.push_back(mode.shape[place.row] * mode.shape[place.column]);
  return residues;
}

void fit_residuals(const ModalFit& fit, const Band& band, const std::vector<Place>& at, SymmetricModel& model) {
  const Basis basis = make_basis(fit.kind, fit.poles(), band.frequency_hz, fit.scale_hz, false);
  const ResidualFitter fitter(basis, band, fit.kind, fit.scale_hz, fit.residues.unit);
  std::vector<ResidualTerms> terms(at.size());
  tbb::parallel_for(std::size_t{0}, at.size(), [&](std::size_t e) {
    if (fit.residues.freedom[e] > 0.0) terms[e] = fitter.fit(e, residues_between(model, at[e]), at[e].sign);
  });
  model.residuals = ResidualTable(core_of(at, model.dofs.size()));
  for (std::size_t e = 0; e < at.size(); ++e) {
    if (terms[e].measured) model.residuals.put(at[e].row, at[e].column, terms[e]);
  }
  model.residuals.complete();
}

/// From the unit of the fit's coefficients, a power of four, to SI.
void multiply(SymmetricModel& model, double unit) {
  const double root = std::sqrt(unit);
  for (SymmetricMode& mode : model.modes) {
    for (Complex& component : mode.shape) component *= root;
    mode.covariance.multiply(unit);
  }
  model.residuals.multiply(unit);
}

std::array<double, 4> pole_block(const ModalFit& fit, std::size_t r) {
  const std::size_t n = 2 * fit.modes.size(), i = 2 * r;
  const auto& c = fit.pole_covariance;
  return {c[i * n + i], c[i * n + i + 1], c[(i + 1) * n + i], c[(i + 1) * n + i + 1]};
}

}  // namespace

std::size_t SymmetricModel::find(const frf::Dof& dof) const {
  const auto found = std::ranges::lower_bound(dofs, frf::coordinate_key(dof), {}, frf::coordinate_key);
  return found != dofs.end() && found->same_coordinate(dof) ? static_cast<std::size_t>(found - dofs.begin()) : frf::npos;
}

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
  const std::vector<Place> at = places(fit, model);
  for (std::size_t r = 0; r < fit.modes.size(); ++r) {
    RankOne one = fit_rank_one(residues_of(fit, r, at), model.dofs.size(), fit.kind.real_modes);
    model.modes.push_back({fit.modes[r].pole, std::move(one.vector), std::move(one.covariance), pole_block(fit, r), one.misfit});
  }
  fit_residuals(fit, band, at, model);
  multiply(model, fit.residues.unit);
  return model;
}

}  // namespace jointid::modalfit
