#pragma once

#include "ident/plan/plan.hpp"
#include "ident/result/control.hpp"

namespace jointid::tasks {

/// One FRF of the assembly: receptance, response over reference.
struct FrfEntry {
  frf::Dof response, reference;

  bool operator==(const FrfEntry&) const = default;
};

/// An assembly FRF, measured and synthesised from the substructures and the identified joint, at the frequencies of its set. NaN:
/// not measured, or not computable from the measured FRFs.
struct RegeneratedFrf {
  FrfEntry entry;
  std::vector<Complex> measured, predicted;
};

struct Regenerated {
  std::vector<double> frequency_hz;
  std::vector<RegeneratedFrf> frfs;
};

/// Lines of both systems, also outside the identification.
std::vector<ident::Line> common_lines(const ident::Plan& plan);

/// The coordinates of the assembly FRFs that both systems allow: the non-joint ones and those of the joint that the assembly has.
ident::Dofs regenerable_responses(const ident::Plan& plan);
ident::Dofs regenerable_references(const ident::Plan& plan);

/// Every k-th element so that at most `count` are left, ends included.
ident::Dofs thinned(const ident::Dofs& dofs, std::size_t count);

/// Up to `count` of the assembly FRFs that both systems allow, spread over responses and references, driving points first.
std::vector<FrfEntry> choose_entries(const ident::Plan& plan, std::size_t count);

/// Synthesises some assembly FRFs at all lines of both systems, also outside the identification. Reads only the rows and columns
/// of the entries and of the joint, and H_bb.
Regenerated regenerate(const ident::Plan& plan, const std::vector<ident::BandMatrices>& bands, const std::vector<FrfEntry>& entries,
                       const ident::Control& control = {});

/// rms over lines of |20 log10(|predicted|/|measured|)|, dB, where both exist; empty if there is no such line.
std::optional<double> decibel_error(const RegeneratedFrf& frf);

}  // namespace jointid::tasks
