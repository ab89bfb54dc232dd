#pragma once

#include <functional>
#include <string>
#include <vector>

#include "ident/check/test/checked_file.hpp"

namespace jointid::ident {

/// A mistake that may have been made, and how to undo it.
struct MistakeTrial {
  SuspectKind kind = SuspectKind::sign;
  std::vector<std::size_t> files;  ///< that change
  Dofs dofs;
  std::string what;    ///< "the sensor at 125:+Y points the other way"
  std::string remedy;  ///< of the first file
  std::function<void(std::vector<CheckedFile>&)> undo;
  double bonus = 0.0;      ///< what the data say for it beside the healing
  double least_score = 0.4;  ///< of a trial that counts
  bool only_span = false;  ///< of no effect on reciprocity and signs; takes all lines that were read
  /// What to compare with, where undoing smooths as well: the same with the mistake left in.
  std::function<void(std::vector<CheckedFile>&)> leave{};
  /// Of a mistake in some references of a file alone: these, and the same mistake in others of them.
  Dofs references{};
  std::function<MistakeTrial(const Dofs& references)> in_others{};
};

/// [data.files."NAME"] and a line below it.
std::string remedy_in(const std::string& file, const std::string& line);

/// As a scene names it.
std::string quoted_dof(const frf::Dof& dof);

}  // namespace jointid::ident
