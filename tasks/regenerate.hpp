#pragma once

#include "ident/plan/plan.hpp"
#include "ident/result/control.hpp"

namespace jointid::tasks {

/// One FRF of the assembly: receptance, response over reference.
struct FrfEntry {
  frf::Dof response, reference;

  bool operator==(const FrfEntry&) const = default;
};

/// An assembly FRF as measured, and as the substructures and the identified joint give it, at the frequencies of
/// Regenerated. NaN: not measured, or not to be had from what was measured.
struct RegeneratedFrf {
  FrfEntry entry;
  std::vector<Complex> measured, predicted;
};

struct Regenerated {
  std::vector<double> frequency_hz;
  std::vector<RegeneratedFrf> frfs;
};

/// Lines that both systems have, those outside the identification too.
std::vector<ident::Line> common_lines(const ident::Plan& plan);

/// The coordinates of the assembly FRFs that both systems allow: the non-joint ones and those of the joint that the assembly has.
ident::Dofs regenerable_responses(const ident::Plan& plan);
ident::Dofs regenerable_references(const ident::Plan& plan);

/// Every k-th element so that at most `count` are left, ends included.
ident::Dofs thinned(const ident::Dofs& dofs, std::size_t count);

/// Up to `count` of the assembly FRFs that both systems allow, spread over responses and references, driving points first.
std::vector<FrfEntry> choose_entries(const ident::Plan& plan, std::size_t count);

/// Regenerates some assembly FRFs at all lines that both systems have, those outside the identification too. Reads the rows
/// and columns of the entries and of the joint only; H_bb too, whether or not the identification read it.
Regenerated regenerate(const ident::Plan& plan, const std::vector<ident::BandMatrices>& bands, const std::vector<FrfEntry>& entries,
                       const ident::Control& control = {});

/// rms over lines of |20 log10(|predicted|/|measured|)|, dB, where both are there; empty where they never are.
std::optional<double> decibel_error(const RegeneratedFrf& frf);

}  // namespace jointid::tasks
