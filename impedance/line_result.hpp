#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/status.hpp"
#include "impedance/law/law_fit.hpp"
#include "impedance/line/line_value.hpp"
#include "impedance/scene/line_scene.hpp"

namespace jointid::impedance {

/// An element of Z, or of z between facing halves.
struct ElementName {
  std::string name;  ///< "Z(1,2)" of the whole matrix, "z(1,2)" between halves, "m(1)"
  std::string unit;
};

/// What a way found, line by line.
struct WayResult {
  Way way = Way::likelihood;
  Structure structure = Structure::symmetric;  ///< of its elements: closed forms have their own
  std::vector<ElementName> elements;
  Basis basis;  ///< of the elements over all joint DOFs
  std::vector<std::optional<LineValue>> lines;
};

/// An element of the first way smoothed over the lines that have a value.
struct SmoothElement {
  std::size_t element = 0;
  std::vector<std::size_t> lines;
  SplineFit fit;
};

struct IdentifiedLines {
  Status status = Status::ok;
  std::string message;
  std::vector<std::string> notes;
  std::vector<frf::Dof> dofs;
  std::vector<double> frequency_hz;
  std::vector<WayResult> ways;                                      ///< as the scene asks; the first is the result
  WayResult likelihood;                                             ///< what the others are judged by
  std::vector<double> condition_substructures, condition_assembly;  ///< of H(j,j); NaN where not measured
  std::vector<Eigen::MatrixXcd> joint_receptance;                   ///< of way `dual`, [lines]
  double chi_square = 0.0, freedom = 0.0, likely = 0.0;             ///< of all lines; χ²/f that chance leaves
  std::size_t restarted = 0, failed = 0;                            ///< lines of the likelihood
  std::vector<LawFit> laws;                                         ///< of the first way, by AIC, least first
  std::vector<SmoothElement> smooth;                                ///< of the first way, where the scene asks
};

}  // namespace jointid::impedance
