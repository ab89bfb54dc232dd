#pragma once

#include "ident/check/test/span_test.hpp"

namespace jointid::ident {

/// A part's FRFs against the same FRFs of an assembly file.
struct Sameness {
  double difference = 1.0;  ///< geometric mean over lines of the rms of |H_asm − H_sub|/√(|H_asm|² + |H_sub|²)
  double across = 0.0;      ///< the same mean of the rms size of FRFs from other parts over that of the part's own
  bool identical = false;   ///< every number, to 1e-9
};

/// Of the FRFs of a setup that is not transposed; empty lines of values give 1.
Sameness sameness(const SpanSetup& setup, const std::vector<CheckedFile>& files);

/// The assembly moves as its parts alone, or a part's file holds the assembly's FRFs. `noise`: of each file.
std::vector<Suspect> find_sameness(const std::vector<CheckedFile>& files, const std::vector<SpanSetup>& setups,
                                   const std::vector<double>& noise);

/// Labels in one file that have no counterpart where another file has one that lacks its own, and the FRFs fit.
std::vector<Suspect> find_labels(const std::vector<CheckedFile>& files, const Dofs& joint);

}  // namespace jointid::ident
