#include "ident/likelihood/model/corrected_line.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "base/eigen.hpp"

namespace jointid::ident {
namespace {

/// ln of what a factor multiplies by, and its derivative by φ.
struct LogFactor {
  Complex value, derivative;
};

LogFactor log_factor(const SystematicUnknown& unknown, const SystematicFactor& factor, double phi, double omega) {
  const double sigma = unknown.deviation;
  switch (unknown.kind) {
    case Systematic::gain:
    case Systematic::scale:
      return {sigma * phi, sigma};
    case Systematic::delay:
      return {Complex(0.0, omega * sigma * phi), Complex(0.0, omega * sigma)};
    case Systematic::stretch:
    case Systematic::angle:
      return {std::log(1.0 - sigma * phi * factor.driving), -sigma * factor.driving / (1.0 - sigma * phi * factor.driving)};
    case Systematic::mass:
      break;
  }
  const Complex load = omega * omega * sigma * factor.driving;
  return {-std::log(1.0 + phi * load), -load / (1.0 + phi * load)};
}

/// Of the value of an FRF in what a factor changes it by: what noise in the value does to that.
Complex own_share(const SystematicUnknown& unknown, const SystematicFactor& factor) {
  if (unknown.kind == Systematic::stretch) return factor.own / factor.driving;
  return unknown.kind == Systematic::angle ? 0.0 : 1.0;
}

/// The derivative of log_factor() at φ = 0.
Complex rate_of(const SystematicUnknown& unknown, const SystematicFactor& factor, double omega) {
  const double sigma = unknown.deviation;
  switch (unknown.kind) {
    case Systematic::gain:
    case Systematic::scale:
      return sigma;
    case Systematic::delay:
      return {0.0, omega * sigma};
    case Systematic::stretch:
    case Systematic::angle:
      return -sigma * factor.driving;
    case Systematic::mass:
      break;
  }
  return -omega * omega * sigma * factor.driving;
}

/// Real and imaginary parts of the blocks of a line as one list of elements.
class Elements {
 public:
  explicit Elements(LineData& line) : channels_{&line.sub_jn, &line.sub_jj, &line.asm_jn, &line.asm_jj, &line.drop_nn} {}

  std::size_t size() const {
    std::size_t sum = 0;
    for (const Channel* channel : channels_) sum += channel->value.size();
    return sum;
  }

  Complex& value(std::size_t element) { return find(&Channel::value, element); }
  Complex& weight(std::size_t element) { return find(&Channel::weight, element); }

  /// E|e|²; 0 where there is no weight.
  double variance(std::size_t element) {
    const Complex w = weight(element);
    return w.real() > 0.0 && w.imag() > 0.0 ? 1.0 / (w.real() * w.real()) + 1.0 / (w.imag() * w.imag()) : 0.0;
  }

 private:
  Complex& find(std::vector<Complex> Channel::* which, std::size_t element) {
    std::size_t c = 0;
    while (element >= (channels_[c]->*which).size()) element -= (channels_[c++]->*which).size();
    return (channels_[c]->*which)[element];
  }

  std::array<Channel*, 5> channels_;
};

/// What corrects an FRF, and what that makes of its error: an FRF along another axis leaves that as it is.
struct Correction {
  Complex by, error;
};

Correction correction(const SystematicFrf& frf, std::span<const SystematicUnknown> unknowns, std::span<const double> phi,
                      double omega, std::vector<SystematicTerm>& terms) {
  const std::size_t begin = terms.size();
  Complex sum = 0.0, error = 0.0;
  for (const SystematicWay& way : frf.ways) {
    Complex log = 0.0, own_log = 0.0;
    const std::size_t own = terms.size();
    for (const SystematicFactor& factor : way.factors) {
      const LogFactor of = log_factor(unknowns[factor.unknown], factor, phi.empty() ? 0.0 : phi[factor.unknown], omega);
      const Systematic kind = unknowns[factor.unknown].kind;
      const bool turns = kind == Systematic::angle || kind == Systematic::stretch;
      log += of.value;
      if (!turns) own_log += of.value;
      terms.push_back({factor.unknown, frf.sign * way.share * of.derivative, {},
                       frf.sign * frf.share * own_share(unknowns[factor.unknown], factor)});
    }
    const Complex multiplier = std::exp(log);
    error += way.share * std::exp(own_log);
    sum += way.share * multiplier;
    for (std::size_t t = own; t < terms.size(); ++t) terms[t].rate *= multiplier;
  }
  for (std::size_t t = begin; t < terms.size(); ++t) {
    terms[t].rate /= sum;
    terms[t].base = sum * frf.value;
  }
  return {sum, error};
}

/// What the noise of the driving points does where masses are taken off: T = M(p,k)/(1 + ω²m M(p,p)) has the error of M(p,p), too, which
/// all FRFs of the row p share, −ω²m T²/M(p,k) times it. Where ω²m|M(p,p)| is not small that is no less than their own.
class DrivingNoise {
 public:
  DrivingNoise(LineData& line, std::span<const SystematicUnknown> unknowns, std::span<const double> phi)
      : line_(line), elements_(line), unknowns_(unknowns), phi_(phi) {}

  /// `by`: what the FRF is multiplied by; `variance`: of the element as measured.
  void add(const SystematicFrf& frf, Complex by, double variance) {
    if (phi_.empty() || !(variance > 0.0)) return;
    const double omega = line_.omega;
    for (const SystematicWay& way : frf.ways) {
      if (std::ranges::none_of(way.factors, [this](const SystematicFactor& factor) { return takes_noise_along(factor); }))
        continue;
      Complex log = 0.0;
      for (const SystematicFactor& factor : way.factors) {
        log += log_factor(unknowns_[factor.unknown], factor, phi_[factor.unknown], omega).value;
      }
      const Complex multiplier = frf.sign * way.share * std::exp(log);
      for (const SystematicFactor& factor : way.factors) {
        if (!takes_noise_along(factor)) continue;
        const double mass = mass_of(factor);
        const Complex rate = -omega * omega * mass / (1.0 + omega * omega * mass * factor.driving);
        const double deviation = std::sqrt(factor.driving_variance);
        any_ = true;
        points_ = std::max(points_, factor.point + 1);
        Shared& of = shared_[frf.element];
        of.factors[factor.point] += multiplier * rate * frf.value * deviation;
        if (way.measures != factor.point || line_.correlation) continue;
        of.factors[factor.point] += multiplier * deviation;
        of.taken += frf.share * std::norm(by) * variance;
      }
    }
  }

  /// Puts it into the weights and the correlation of the line.
  void apply() {
    if (!any_) return;
    const std::vector<std::size_t> some = dependent_elements();
    const auto n = at(some.size());
    Eigen::MatrixXcd factors = Eigen::MatrixXcd::Zero(n, at(points_));
    Eigen::VectorXd own(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const std::size_t element = some[static_cast<std::size_t>(i)];
      own[i] = elements_.variance(element);
      const auto of = shared_.find(element);
      if (of == shared_.end()) continue;
      own[i] = std::max(0.0, own[i] - of->second.taken);
      for (const auto& [point, factor] : of->second.factors) factors(i, at(point)) = factor;
    }
    Eigen::MatrixXcd covariance = factors * factors.adjoint();
    const Eigen::VectorXd total = own + covariance.diagonal().real();
    if (line_.correlation) add_told(some, covariance);
    for (Eigen::Index i = 0; i < n; ++i) {
      const std::size_t element = some[static_cast<std::size_t>(i)];
      elements_.weight(element) *= std::sqrt(elements_.variance(element) / total[i]);
    }
    minimise::Correlation out = minimise::Correlation::of(elements_.size(), some, covariance, total);
    line_.correlation = out.groups().empty() ? nullptr : std::make_shared<const minimise::Correlation>(std::move(out));
  }

 private:
  /// The errors of driving points in an element, in their standard deviations, and the part of its own variance that is one of them.
  struct Shared {
    std::map<std::size_t, Complex> factors;
    double taken = 0.0;
  };

  double mass_of(const SystematicFactor& factor) const { return unknowns_[factor.unknown].deviation * phi_[factor.unknown]; }

  /// Whether taking the mass off brings the noise of its driving point.
  bool takes_noise_along(const SystematicFactor& factor) const {
    return unknowns_[factor.unknown].kind == Systematic::mass && mass_of(factor) != 0.0 && factor.driving_variance > 0.0;
  }

  /// Those with errors of driving points, and those that depend on others already; ascending.
  std::vector<std::size_t> dependent_elements() const {
    std::vector<std::size_t> some;
    for (const auto& [element, of] : shared_) some.push_back(element);
    if (!line_.correlation) return some;
    for (const minimise::Correlation::Group& group : line_.correlation->groups()) {
      for (const std::size_t element : group.elements) {
        if (!shared_.contains(element)) some.push_back(element);
      }
    }
    std::ranges::sort(some);
    return some;
  }

  /// Adds the covariances that the line has told, but for the diagonal.
  void add_told(const std::vector<std::size_t>& some, Eigen::MatrixXcd& covariance) {
    for (std::size_t i = 0; i < some.size(); ++i) {
      const minimise::Correlation::Place one = line_.correlation->place(some[i]);
      for (std::size_t k = 0; k < some.size(); ++k) {
        const minimise::Correlation::Place other = line_.correlation->place(some[k]);
        if (i == k || one.group == minimise::Correlation::none || one.group != other.group) continue;
        const Eigen::MatrixXcd& factor = line_.correlation->groups()[one.group].factor;
        const Complex rho = (factor.row(at(one.row)) * factor.row(at(other.row)).adjoint()).value();
        covariance(at(i), at(k)) += rho * std::sqrt(elements_.variance(some[i]) * elements_.variance(some[k]));
      }
    }
  }

  LineData& line_;
  Elements elements_;
  std::span<const SystematicUnknown> unknowns_;
  std::span<const double> phi_;
  std::map<std::size_t, Shared> shared_;
  std::size_t points_ = 0;  ///< driving points of the line
  bool any_ = false;
};

/// Brings a line without its systematic errors together, element by element.
class Corrector {
 public:
  Corrector(const LineData& measured, LineData& out, std::span<const SystematicUnknown> unknowns, std::span<const double> phi)
      : out_(out), elements_(out), unknowns_(unknowns), phi_(phi), driving_(out, unknowns, phi) {
    if (measured.systematic) frfs_ = *measured.systematic;  // lives as long as `measured`
    if (measured.scaled) changes_ = measured.scaled->at(phi);
    terms_->unknowns = unknowns.size();
    terms_->first.assign(elements_.size() + 1, 0);
  }

  void run() {
    auto frf = frfs_.begin();
    auto change = changes_.begin();
    for (std::size_t element = 0; element < elements_.size(); ++element) {
      double variance = 1.0;  // over that of the measured element
      const double measured_variance = elements_.variance(element);
      Complex scaled = 0.0;
      for (; change != changes_.end() && change->element == element; ++change) scaled += scale(*change, variance);
      for (; frf != frfs_.end() && frf->element == element; ++frf) correct(*frf, scaled, measured_variance, variance);
      elements_.weight(element) /= std::sqrt(variance);
      terms_->first[element + 1] = terms_->terms.size();
    }
    driving_.apply();
    out_.terms = std::move(terms_);
  }

 private:
  /// A part's stiffness and mass come first: what else is wrong with its FRFs is so of the FRFs of the scaled part.
  Complex scale(const ScaledFrfs::Change& change, double& variance) {
    elements_.value(change.element) += change.value;
    variance += change.share * (change.size * change.size - 1.0);
    for (const auto& [unknown, rate] : change.rates) terms_->terms.push_back({unknown, rate, 1.0, 0.0});
    return change.value;
  }

  /// `scaled`: what a part's scales have changed its FRF by; those of the assembly, negative in D, have none.
  void correct(const SystematicFrf& described, Complex scaled, double measured_variance, double& variance) {
    SystematicFrf moved;
    const bool is_moved = scaled != 0.0 && described.sign > 0.0;
    if (is_moved) {
      moved = described;
      moved.value += scaled;
    }
    const SystematicFrf& frf = is_moved ? moved : described;
    const auto [by, error] = correction(frf, unknowns_, phi_, out_.omega, terms_->terms);
    elements_.value(frf.element) += frf.sign * (by - 1.0) * frf.value;
    variance += frf.share * (std::norm(error) - 1.0);
    driving_.add(frf, error, measured_variance);
  }

  LineData& out_;
  Elements elements_;
  std::span<const SystematicUnknown> unknowns_;
  std::span<const double> phi_;
  DrivingNoise driving_;
  std::span<const SystematicFrf> frfs_;
  std::vector<ScaledFrfs::Change> changes_;
  std::shared_ptr<SystematicTerms> terms_ = std::make_shared<SystematicTerms>();
};

}  // namespace

LineData corrected_line(const LineData& measured, std::span<const SystematicUnknown> unknowns, std::span<const double> phi) {
  LineData out = measured;
  if (measured.systematic || measured.scaled) Corrector(measured, out, unknowns, phi).run();
  return out;
}

void write_terms(const LineData& measured, std::span<const SystematicUnknown> unknowns, SystematicTerms& out) {
  out.unknowns = unknowns.size();
  out.terms.clear();
  out.first.assign(1, 0);
  for (const SystematicFrf& frf : *measured.systematic) {
    while (out.first.size() <= frf.element) out.first.push_back(out.terms.size());
    for (const SystematicWay& way : frf.ways) {
      for (const SystematicFactor& factor : way.factors) {
        const SystematicUnknown& unknown = unknowns[factor.unknown];
        out.terms.push_back({factor.unknown, frf.sign * way.share * rate_of(unknown, factor, measured.omega), frf.value,
                             frf.sign * frf.share * own_share(unknown, factor)});
      }
    }
  }
  std::size_t elements = 0;
  for (const Channel* channel : {&measured.sub_jn, &measured.sub_jj, &measured.asm_jn, &measured.asm_jj, &measured.drop_nn})
    elements += channel->value.size();
  out.first.resize(elements + 1, out.terms.size());
}

}  // namespace jointid::ident
