#include "ident/likelihood/line/corrected_line.hpp"

#include <array>
#include <cmath>

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
      return {sigma * phi, sigma};
    case Systematic::delay:
      return {Complex(0.0, omega * sigma * phi), Complex(0.0, omega * sigma)};
    case Systematic::mass:
      break;
  }
  const Complex load = omega * omega * sigma * factor.driving;
  return {-std::log(1.0 + phi * load), -load / (1.0 + phi * load)};
}

/// Real and imaginary parts of the blocks of a line as one list of elements.
class Elements {
 public:
  explicit Elements(LineData& line) : channels_{&line.x, &line.y, &line.a, &line.b, &line.d} {}

  std::size_t size() const {
    std::size_t sum = 0;
    for (const Channel* channel : channels_) sum += channel->value.size();
    return sum;
  }

  void correct(std::size_t element, Complex change, double error) {
    for (Channel* channel : channels_) {
      if (element < channel->value.size()) {
        channel->value[element] += change;
        channel->weight[element] /= error;
        return;
      }
      element -= channel->value.size();
    }
  }

 private:
  std::array<Channel*, 5> channels_;
};

/// What corrects an FRF, and its terms.
Complex correction(const SystematicFrf& frf, std::span<const SystematicUnknown> unknowns, std::span<const double> phi,
                   double omega, std::vector<SystematicTerm>& terms) {
  const std::size_t begin = terms.size();
  Complex sum = 0.0;
  for (const SystematicWay& way : frf.ways) {
    Complex log = 0.0;
    const std::size_t own = terms.size();
    for (const SystematicFactor& factor : way.factors) {
      const LogFactor of = log_factor(unknowns[factor.unknown], factor, phi.empty() ? 0.0 : phi[factor.unknown], omega);
      log += of.value;
      terms.push_back({factor.unknown, frf.sign * way.share * of.derivative, {}, frf.sign * frf.share});
    }
    const Complex multiplier = std::exp(log);
    sum += way.share * multiplier;
    for (std::size_t t = own; t < terms.size(); ++t) terms[t].rate *= multiplier;
  }
  for (std::size_t t = begin; t < terms.size(); ++t) {
    terms[t].rate /= sum;
    terms[t].base = sum * frf.value;
  }
  return sum;
}

}  // namespace

LineData corrected_line(const LineData& measured, std::span<const SystematicUnknown> unknowns, std::span<const double> phi) {
  LineData out = measured;
  if (!measured.systematic) return out;
  const SystematicFrfs& frfs = *measured.systematic;
  Elements elements(out);
  auto terms = std::make_shared<SystematicTerms>();
  terms->unknowns = unknowns.size();
  terms->first.assign(elements.size() + 1, 0);
  for (std::size_t i = 0; i < frfs.size();) {
    const std::size_t element = frfs[i].element;
    Complex change = 0.0;
    double variance = 1.0;  // over that of the measured element
    for (; i < frfs.size() && frfs[i].element == element; ++i) {
      const Complex by = correction(frfs[i], unknowns, phi, measured.omega, terms->terms);
      change += frfs[i].sign * (by - 1.0) * frfs[i].value;
      variance += frfs[i].share * (std::norm(by) - 1.0);
    }
    elements.correct(element, change, std::sqrt(variance));
    terms->first[element + 1] = terms->terms.size();
  }
  for (std::size_t e = 1; e < terms->first.size(); ++e) terms->first[e] = std::max(terms->first[e], terms->first[e - 1]);
  out.terms = std::move(terms);
  return out;
}

}  // namespace jointid::ident
