#pragma once

#include <limits>
#include <vector>

#include "base/complex.hpp"

namespace jointid::ident {

/// Errors that all lines share, as unknowns φ beside the joint, in standard deviations σ of their normal priors about 0.
enum class Systematic {
  gain,   ///< e^{σφ}: true FRF = gain · measured
  delay,  ///< σφ in s by which the responses lag: e^{iωσφ}
  stretch,  ///< σφ by which all frequencies and, as a square, all stiffness of a file's structure changed: measured + σφ (ω H' +
            ///< 2 H)
  angle,  ///< σφ in rad by which the axis of a sensor is turned towards another one: measured − σφ · that other FRF
  scale,  ///< e^{σφ}: stiffness or mass of a part that is a model, over the model's (ScaledFrfs); no factor of an FRF
  mass  ///< σφ in kg that the structure carries at the response p, with p: 1/(1 + ω²σφ H(p,p)), free of what is removed as known
};

struct SystematicUnknown {
  Systematic kind;
  double deviation;  ///< σ
};

/// An unknown in what a measured FRF is multiplied by.
struct SystematicFactor {
  std::size_t unknown = 0;
  Complex driving{};              ///< of a mass: H(p,p) as measured; of an angle: the FRF along the other axis over this one
  std::size_t point = 0;          ///< which driving point of the line that is
  double driving_variance = 0.0;  ///< E|e|² of it; 0: not known, or exact
  Complex own{};                  ///< of a stretch, whose driving is −(ω H' + 2 H)/H: what of it comes from the value of H itself
};

/// A way in which an FRF was measured, there or back.
struct SystematicWay {
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  double share = 1.0;  ///< in the average
  std::vector<SystematicFactor> factors;
  std::size_t measures = none;  ///< the driving point that this FRF is itself
};

/// The measured FRF of one system in the value of an element.
struct SystematicFrf {
  std::size_t element = 0;          ///< of a line, in the order x, y, a, b, d
  double sign = 1.0;                ///< −1: H_asm(n,n) in D
  Complex value;                    ///< measured
  double share = 1.0;               ///< of the variance of the element
  std::vector<SystematicWay> ways;  ///< their shares add up to 1
};

/// The FRFs of a line with systematic errors, by ascending element.
using SystematicFrfs = std::vector<SystematicFrf>;

/// How an element changes with an unknown: ∂value/∂φ = rate · (base − share · residual). What is in brackets is the FRF that the
/// residual leaves for true: with the measured one instead the noise in it would bias gains and stretches towards zero.
struct SystematicTerm {
  std::size_t unknown = 0;
  Complex rate, base, share = 1.0;

  Complex derivative(Complex residual) const { return rate * (base - share * residual); }
};

/// All terms of a line.
struct SystematicTerms {
  std::size_t unknowns = 0;
  std::vector<std::size_t> first;  ///< [elements + 1] where those of an element begin
  std::vector<SystematicTerm> terms;

  bool has(std::size_t element) const { return first[element + 1] > first[element]; }
};

}  // namespace jointid::ident
