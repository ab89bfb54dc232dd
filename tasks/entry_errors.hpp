#pragma once

#include "tasks/regenerate.hpp"

namespace jointid::tasks {

/// How far the regenerated FRFs of the assembly are from the measured ones.
struct EntryErrors {
  ident::Dofs responses, references;
  std::vector<double>
      rms_db;  ///< [R×C] rms over lines of |20 log10(|predicted|/|measured|)|; NaN where there is nothing to compare
  /// [R×C] rms over lines of |predicted − measured| over its standard deviation: that of the measured FRF and, where they are
  /// known, what the errors of the substructures' FRFs make of the predicted one, to first order; NaN where the first is not
  /// known, empty where it is known of no FRF (variances of files, repeats or [noise] count, the scatter of lines does not).
  std::vector<double> rms_noise{};
  std::size_t lines = 0;
  std::size_t all_responses = 0, all_references = 0;  ///< of which those above are an even selection
};

/// Compares the assembly FRFs that both systems allow, at all lines that both have, those outside the identification too, in one
/// pass over the files. With very many coordinates an even selection, so that reading and working stay within about 2·10⁹
/// products. FRFs more than 180 dB below the largest of their line count as zero and are left out.
EntryErrors entry_errors(const ident::Plan& plan, const std::vector<ident::BandMatrices>& bands, const ident::Control& control = {});

}  // namespace jointid::tasks
