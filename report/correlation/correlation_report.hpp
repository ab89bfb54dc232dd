#pragma once

#include <string>
#include <vector>

#include "correlation/correlated_frfs.hpp"
#include "correlation/correlated_modes.hpp"
#include "correlation/expanded_frfs.hpp"

namespace jointid::report {

/// What was compared, by name, and what speaks against it.
struct ComparedFiles {
  std::string one, other;
  std::vector<std::string> notes{};
};

/// The FRFs that agree least (by FRAC), the lines that do, χ² over degrees of freedom, and what the criteria do not see.
std::string correlation_text(const ComparedFiles& files, const correlation::CorrelatedFrfs& found);
/// `shapes`: nullptr for none.
std::string correlation_json(const ComparedFiles& files, const correlation::CorrelatedFrfs& found,
                             const correlation::ShapesOverLines* shapes);
/// One FRF a row.
std::string correlation_csv(const correlation::CorrelatedFrfs& found);

std::string correlation_text(const ComparedFiles& files, const correlation::CorrelatedModes& found);
std::string correlation_json(const ComparedFiles& files, const correlation::CorrelatedModes& found);
/// One mode of the first file a row.
std::string correlation_csv(const correlation::CorrelatedModes& found);

/// `way`: as the command has it; `out`: the file of the FRFs.
struct ExpansionNames {
  std::string parent, measured, way, out;
  std::vector<std::string> notes{};
};

std::string expansion_text(const ExpansionNames& names, const correlation::ExpandedFrfs& found);
std::string expansion_json(const ExpansionNames& names, const correlation::ExpandedFrfs& found);

}  // namespace jointid::report
