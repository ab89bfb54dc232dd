#include "impedance/law/law_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dense/cholesky.hpp"
#include "minimise/linear/covariance.hpp"

namespace jointid::impedance {
namespace {

using Index = Eigen::Index;
using Vector = Eigen::VectorXd;

/// A line that counts: values and the factor of their covariance, C = L Lᵀ over scale².
struct WhitenedLine {
  std::size_t number;
  double omega;
  Vector scale;
  Eigen::MatrixXd lower;
  Vector value;  ///< whitened

  Eigen::MatrixXd whitened(Eigen::MatrixXd rows) const {
    rows = scale.cwiseInverse().asDiagonal() * rows;
    dense::solve_lower(lower, rows);
    return rows;
  }
};

std::vector<WhitenedLine> whitened_lines(const std::vector<double>& omega, const std::vector<std::optional<LineValue>>& lines) {
  std::vector<WhitenedLine> out;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!lines[i] || !lines[i]->z.allFinite() || !lines[i]->covariance.allFinite()) continue;
    const Vector scale = lines[i]->covariance.diagonal().cwiseSqrt();
    if (!(scale.minCoeff() > 0.0)) continue;
    const auto lower =
        dense::cholesky(scale.cwiseInverse().asDiagonal() * lines[i]->covariance * scale.cwiseInverse().asDiagonal());
    if (!lower) continue;
    out.push_back({i, omega[i], scale, *lower, {}});
    Vector parts(2 * lines[i]->z.size());
    parts << lines[i]->z.real(), lines[i]->z.imag();
    out.back().value = out.back().whitened(parts);
  }
  return out;
}

/// The law as a function of all its parameters: those of z_1, z_2, …, or where they share it K_1, K_2, … and what multiplies
/// them, then the masses.
class Model {
 public:
  Model(LawKind law, const LawLayout& layout)
      : law_(law), layout_(layout), each_(static_cast<Index>(parameters_of(law, "").size())), elements_(layout.place.cols()) {}

  Index size() const { return (layout_.shared ? elements_ + each_ - 1 : each_ * elements_) + layout_.mass.cols(); }
  LawKind law() const { return law_; }

  /// Where τ stands, with α behind it where there is one.
  std::vector<Index> shape_places() const {
    std::vector<Index> out;
    if (shape_count(law_) == 0) return out;
    if (layout_.shared) return {elements_ + 1};
    for (Index s = 0; s < elements_; ++s) out.push_back(s * each_ + 2);
    return out;
  }

  /// Whether the value is linear in a parameter while those of which it is not are fixed: shapes, or all that elements share.
  bool is_linear(Index k) const {
    if (k >= size() - layout_.mass.cols()) return true;
    if (layout_.shared) return k < elements_;
    return shape_count(law_) == 0 || k % each_ < 2;
  }

  /// Parameters of all elements from those of one.
  Vector start_from(const Vector& one) const {
    Vector out = Vector::Zero(size());
    for (Index s = 0; s < elements_ && !layout_.shared; ++s) out.segment(s * each_, each_) = one;
    if (layout_.shared) out.segment(elements_, each_ - 1) = ratios_of(one);
    return out;
  }

  /// Values of the elements and their slopes, real over imaginary parts.
  void evaluate(double omega, const Vector& theta, Vector& value, Eigen::MatrixXd& slope) const {
    const Index rows = layout_.place.rows(), masses = layout_.mass.cols();
    Eigen::VectorXcd z = Eigen::VectorXcd::Zero(rows);
    Eigen::MatrixXcd by = Eigen::MatrixXcd::Zero(rows, size());
    layout_.shared ? add_shared(omega, theta, z, by) : add_each(omega, theta, z, by);
    z -= omega * omega * layout_.mass * theta.tail(masses);
    by.rightCols(masses) = (-omega * omega * layout_.mass).cast<Complex>();
    value.resize(2 * rows);
    value << z.real(), z.imag();
    slope.resize(2 * rows, size());
    slope << by.real(), by.imag();
  }

 private:
  void add_each(double omega, const Vector& theta, Eigen::VectorXcd& z, Eigen::MatrixXcd& by) const {
    for (Index s = 0; s < elements_; ++s) {
      const LawValue one = law_value(law_, omega, theta.segment(s * each_, each_));
      z += layout_.place.col(s) * one.z;
      by.middleCols(s * each_, each_) += layout_.place.col(s) * one.slope.transpose();
    }
  }

  void add_shared(double omega, const Vector& theta, Eigen::VectorXcd& z, Eigen::MatrixXcd& by) const {
    Vector unit(each_);
    unit << 1.0, theta.segment(elements_, each_ - 1);
    const LawValue g = law_value(law_, omega, unit);
    const Eigen::VectorXd stiffness = layout_.place * theta.head(elements_);
    z += stiffness * g.z;
    by.leftCols(elements_) = layout_.place * g.z;
    by.middleCols(elements_, each_ - 1) = stiffness * g.slope.tail(each_ - 1).transpose();
  }

  /// Parameters behind the first in parts of it, but for shapes.
  Vector ratios_of(const Vector& one) const {
    Vector out = one.tail(each_ - 1);
    const auto shapes = static_cast<Index>(shape_count(law_));
    if (one(0) != 0.0) out.head(each_ - 1 - shapes) /= one(0);
    return out;
  }

  LawKind law_;
  const LawLayout& layout_;
  Index each_, elements_;
};

struct Normal {
  Eigen::MatrixXd information;
  Vector gradient;
  double chi_square = 0.0;
};

Normal normal_of(const Model& model, const std::vector<WhitenedLine>& lines, const Vector& theta) {
  Normal out{Eigen::MatrixXd::Zero(model.size(), model.size()), Vector::Zero(model.size())};
  Vector value;
  Eigen::MatrixXd slope;
  for (const WhitenedLine& line : lines) {
    model.evaluate(line.omega, theta, value, slope);
    const Vector residual = line.value - line.whitened(value);
    const Eigen::MatrixXd j = line.whitened(slope);
    out.information += j.transpose() * j;
    out.gradient += j.transpose() * residual;
    out.chi_square += residual.squaredNorm();
  }
  return out;
}

/// Parts of a step that would leave τ > 0, 0 < α ≤ 1 are cut.
Vector stepped(const Model& model, const Vector& theta, const Vector& step) {
  Vector out = theta + step;
  for (const Index tau : model.shape_places()) {
    out(tau) = std::clamp(out(tau), 0.2 * theta(tau), 5.0 * theta(tau));
    if (shape_count(model.law()) > 1) out(tau + 1) = std::clamp(out(tau + 1), 0.5 * theta(tau + 1), 1.0);
  }
  return out;
}

/// The parameters that the value is linear in, the others given.
void solve_linear(const Model& model, const std::vector<WhitenedLine>& lines, Vector& theta) {
  std::vector<Index> free;
  for (Index k = 0; k < model.size(); ++k) {
    if (!model.is_linear(k)) continue;
    free.push_back(k);
    theta(k) = 0.0;
  }
  const Normal normal = normal_of(model, lines, theta);
  Eigen::MatrixXd information(static_cast<Index>(free.size()), static_cast<Index>(free.size()));
  Vector gradient(information.rows());
  for (Index r = 0; r < information.rows(); ++r) {
    gradient(r) = normal.gradient(free[static_cast<std::size_t>(r)]);
    for (Index c = 0; c < information.cols(); ++c)
      information(r, c) = normal.information(free[static_cast<std::size_t>(r)], free[static_cast<std::size_t>(c)]);
  }
  const Vector solved = minimise::determined_step(information, gradient);
  for (Index r = 0; r < solved.size(); ++r) theta(free[static_cast<std::size_t>(r)]) = solved(r);
}

/// Levenberg–Marquardt; whether it came to an end.
bool descend(const Model& model, const std::vector<WhitenedLine>& lines, Vector& theta, double& chi_square) {
  constexpr int most = 300;
  constexpr double settled = 1e-9, rounding = 1e-14;
  Normal normal = normal_of(model, lines, theta);
  double damping = 0.0;
  for (int step = 0; step < most; ++step) {
    Eigen::MatrixXd damped = normal.information;
    damped.diagonal() *= 1.0 + damping;
    const Vector next = stepped(model, theta, minimise::determined_step(damped, normal.gradient));
    const Vector change = next - theta;
    const double size = std::sqrt(std::max(0.0, change.dot(normal.information * change)));
    const Normal reached = normal_of(model, lines, next);
    if (reached.chi_square <= normal.chi_square * (1.0 + rounding)) {
      theta = next;
      normal = reached;
      damping = damping > 1e-6 ? 0.1 * damping : 0.0;
      chi_square = normal.chi_square;
      if (size < settled && damping == 0.0) return true;
    } else {
      if (size < 1e-6) return true;
      damping = std::max(10.0 * damping, 1e-3);
      if (damping > 1e12) return false;
    }
  }
  return false;
}

/// Parameters of one element to begin from: relaxation times over the band and beyond it, a few exponents.
std::vector<Vector> element_starts(LawKind law, const std::vector<WhitenedLine>& lines) {
  Vector one = Vector::Zero(static_cast<Index>(parameters_of(law, "").size()));
  if (shape_count(law) == 0) return {one};
  const double low = std::max(1e-3, lines.front().omega), high = std::max(1.001 * low, lines.back().omega);
  std::vector<Vector> out;
  for (const double alpha : law == LawKind::zener ? std::vector<double>{1.0} : std::vector<double>{0.35, 0.6, 0.9}) {
    for (int k = -1; k <= 5; ++k) {
      one(2) = 1.0 / (low * std::pow(high / low, k / 4.0));
      if (shape_count(law) > 1) one(3) = alpha;
      out.push_back(one);
    }
  }
  return out;
}

/// The line values of the element that is known best beside its size, alone.
std::vector<std::optional<LineValue>> best_element(const LawLayout& layout, const std::vector<std::optional<LineValue>>& lines,
                                                   Index& which) {
  const auto known = [&](Index e) {
    double sum = 0.0;
    for (const auto& line : lines) {
      if (line && line->variance(e) > 0.0) sum += std::norm(line->z(e)) / line->variance(e);
    }
    return sum;
  };
  which = 0;
  for (Index e = 1; e < layout.place.rows(); ++e) {
    if (layout.place.row(e).cwiseAbs().sum() > 0.0 && known(e) > known(which)) which = e;
  }
  std::vector<std::optional<LineValue>> out;
  for (const auto& line : lines) {
    out.emplace_back();
    if (!line) continue;
    const Index t = line->z.size();
    out.back() = LineValue();
    out.back()->z = Eigen::VectorXcd::Constant(1, line->z(which));
    out.back()->covariance.resize(2, 2);
    const Eigen::MatrixXd& c = line->covariance;
    out.back()->covariance << c(which, which), c(which, t + which), c(t + which, which), c(t + which, t + which);
  }
  return out;
}

/// Where descents begin: for a common law from that of the best known element.
std::vector<Vector> starts_of(const Model& model, const LawLayout& layout, const std::vector<double>& omega,
                              const std::vector<std::optional<LineValue>>& lines, const std::vector<WhitenedLine>& used) {
  std::vector<Vector> out;
  if (!layout.shared) {
    for (const Vector& one : element_starts(model.law(), used)) out.push_back(model.start_from(one));
    return out;
  }
  Index which = 0;
  const auto alone = best_element(layout, lines, which);
  const LawLayout single{{"z"}, {""}, Eigen::MatrixXd::Ones(1, 1), Eigen::MatrixXd(1, 0), {}, {}};
  const LawFit fit = fit_law(model.law(), single, omega, alone);
  if (fit.theta.size() > 0) out.push_back(model.start_from(fit.theta));
  return out;
}

void name_parameters(const LawLayout& layout, LawFit& out) {
  Index k = 0;
  const auto add = [&](const std::string& name, const std::string& unit) {
    out.parameters.push_back({name, unit, out.theta(k), std::sqrt(out.covariance(k, k))});
    ++k;
  };
  if (layout.shared) {
    const std::vector<LawParameter> law = parameters_of(out.law, "1");
    for (std::size_t s = 0; s < layout.names.size(); ++s) add(law.front().name + " of " + layout.names[s], layout.units[s]);
    for (std::size_t p = 1; p < law.size(); ++p) {
      const bool is_shape = p + shape_count(out.law) >= law.size();
      add(is_shape ? law[p].name : law[p].name + "/" + law.front().name, law[p].unit);
    }
  } else {
    for (std::size_t s = 0; s < layout.names.size(); ++s) {
      for (const LawParameter& parameter : parameters_of(out.law, layout.units[s])) {
        add(layout.names.size() == 1 ? parameter.name : parameter.name + " of " + layout.names[s], parameter.unit);
      }
    }
  }
  for (std::size_t i = 0; i < layout.mass_names.size(); ++i) add(layout.mass_names[i], layout.mass_units[i]);
}

}  // namespace

LawFit fit_law(LawKind law, const LawLayout& layout, const std::vector<double>& omega,
               const std::vector<std::optional<LineValue>>& lines) {
  const std::vector<WhitenedLine> used = whitened_lines(omega, lines);
  const Model model(law, layout);
  LawFit out;
  out.law = law;
  const double rows = 2.0 * static_cast<double>(layout.place.rows()) * static_cast<double>(used.size());
  out.freedom = rows - static_cast<double>(model.size());
  if (used.empty() || out.freedom < 0.0) return out;
  out.chi_square = std::numeric_limits<double>::infinity();
  for (Vector theta : starts_of(model, layout, omega, lines, used)) {
    solve_linear(model, used, theta);
    double chi_square = std::numeric_limits<double>::infinity();
    const bool converged = descend(model, used, theta, chi_square);
    if (!(chi_square < out.chi_square)) continue;
    out.chi_square = chi_square;
    out.theta = theta;
    out.converged = converged;
  }
  if (!std::isfinite(out.chi_square)) return out;
  const Normal normal = normal_of(model, used, out.theta);
  out.covariance = minimise::covariance_of(normal.information);
  out.aic = out.chi_square + 2.0 * static_cast<double>(model.size());
  out.by_line.assign(lines.size(), std::nan(""));
  out.lines.resize(lines.size());
  Vector value;
  Eigen::MatrixXd slope;
  for (const WhitenedLine& line : used) {
    model.evaluate(line.omega, out.theta, value, slope);
    out.by_line[line.number] = (line.value - line.whitened(value)).squaredNorm();
    const Index count = value.size() / 2;
    LineValue one;
    one.z = value.head(count) + Complex(0.0, 1.0) * value.tail(count);
    one.covariance = slope * out.covariance * slope.transpose();
    out.lines[line.number] = std::move(one);
  }
  name_parameters(layout, out);
  return out;
}

std::vector<LawFit> fit_laws(const std::vector<LawKind>& laws, const LawLayout& layout, const std::vector<double>& omega,
                             const std::vector<std::optional<LineValue>>& lines) {
  std::vector<LawFit> out;
  for (const LawKind law : laws) out.push_back(fit_law(law, layout, omega, lines));
  std::ranges::stable_sort(
      out, [](const LawFit& a, const LawFit& b) { return std::pair(!a.converged, a.aic) < std::pair(!b.converged, b.aic); });
  return out;
}

}  // namespace jointid::impedance
