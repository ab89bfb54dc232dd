#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ident/result/solution.hpp"
#include "impedance/identify_lines.hpp"

namespace jointid::impedance {

/// What `identify_lines` will read and find at a line, from the headers of the files and their first line.
struct LinePlan {
  std::vector<frf::Dof> dofs;
  std::vector<double> frequency_hz;
  std::vector<ElementName> elements;                        ///< of the scene's structure
  std::vector<std::pair<std::string, std::size_t>> blocks;  ///< "H_sub(j,n)", and how many FRFs of it, reciprocal pairs once
  double freedom = 0.0;                                     ///< degrees of freedom of the line
  std::vector<ident::VarianceSource> variances;
  std::vector<std::string> warnings, notes;
  /// Z and its covariance at every line from the FRFs that are there: at exact FRFs, of a model, the Cramér–Rao bound of data with the
  /// errors that the scene states. Of measured ones an estimate of it. Empty where it is not asked for.
  std::optional<IdentifiedLines> bound{};
};

/// Throws InputError as identify_lines() does. `with_bound` reads the files.
LinePlan plan_lines(const LineScene& scene, bool with_bound, const ident::Control& control = {});

}  // namespace jointid::impedance
