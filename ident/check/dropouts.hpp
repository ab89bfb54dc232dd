#pragma once

#include <map>
#include <vector>

#include "ident/check/agreement.hpp"

namespace jointid::ident {

/// log |H| of an FRF on a line against the mean of its neighbour lines.
double jump(const CheckedFile& file, const frf::Dof& response, const frf::Dof& reference, std::size_t line);

/// Whether one FRF at one line is what the others do not agree with.
bool is_one_number(const Agreement& test);

/// Lines of files that contradict all others of their file, while these agree: dropouts, overload, lines without excitation.
class Dropouts {
 public:
  explicit Dropouts(const std::vector<CheckedFile>& files) : files_(files) {}

  /// The test without such lines, where there are any; they are kept in mind for the file.
  Agreement take_out(std::size_t file, Agreement mirror);
  /// The same; of the two files the one whose FRFs jump most on the line is the one that it is kept in mind for.
  Agreement take_out(const SpanSetup& setup, Agreement span);

  bool empty() const { return lines_.empty(); }
  /// An `outlier` for each file.
  std::vector<Suspect> suspects() const;

 private:
  const std::vector<CheckedFile>& files_;
  std::map<std::size_t, std::map<std::size_t, double>> lines_;  ///< of files: lines with χ² over its expectation
};

}  // namespace jointid::ident
