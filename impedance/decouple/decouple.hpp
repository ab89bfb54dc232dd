#pragma once

#include <optional>

#include "impedance/decouple/decouple_scene.hpp"
#include "impedance/decouple/decoupled_line.hpp"
#include "impedance/identify_lines.hpp"

namespace jointid::impedance {

/// FRFs of B by a way.
struct DecoupledWay {
  DecoupleWay way = DecoupleWay::likelihood;
  std::vector<frf::Dof> dofs;  ///< u: the interface; by other ways than the likelihood then the DOFs of AB that A lacks
  std::vector<std::optional<DecoupledLine>> lines;
};

struct Decoupled {
  Status status = Status::ok;
  std::string message;
  std::vector<std::string> notes;
  std::vector<double> frequency_hz;
  std::vector<DecoupledWay> ways;  ///< as the scene asks
  IdentifiedLines likelihood;      ///< Z of B at the interface
};

/// B from AB and A. Status as identify_lines() gives it of the likelihood, which other ways are held against; doubtful, too,
/// where errors to first order are above a tenth of the FRFs. Throws InputError as identify_lines().
Decoupled decouple(const DecoupleScene& scene, const ident::Control& control = {});
Decoupled decouple(const DecoupleScene& scene, const std::vector<frf::FrfSet>& a, const std::vector<frf::FrfSet>& whole,
                   const ident::Control& control = {});

/// Receptances with variances, and covariances between the responses of each reference.
frf::FrfSet frfs_of(const Decoupled& decoupled, const DecoupledWay& way);

}  // namespace jointid::impedance
