#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/status.hpp"
#include "frf/set/frf_set.hpp"
#include "modalfit/band/band.hpp"
#include "modalfit/band/model_kind.hpp"
#include "modalfit/band/pole.hpp"
#include "modalfit/poles/polyreference.hpp"
#include "modalfit/poles/residues.hpp"

namespace jointid::modalfit {

struct FitOptions {
  ModelKind kind{};
  std::optional<std::array<double, 2>> range_hz = std::nullopt;  ///< both ends included; default: all lines
  std::optional<std::size_t> modes = std::nullopt;  ///< keep the most significant so many; default: all that are significant
  /// Given: no modes are sought, but these, which are refined; there is then no stabilisation diagram.
  std::optional<std::vector<Pole>> poles = std::nullopt;
  double most_damping = 0.3;                      ///< 0 < ζ ≤ this
  PolyreferenceOptions polyreference{};
  /// FRFs by which poles are selected and refined; with more, those of the chosen inputs, evenly thinned.
  std::size_t most_refined = 400;
  std::function<void(const char* stage)> progress{};
  std::function<bool()> interrupted{};  ///< asked between steps of the refinement; the fit then stops where it is
  std::function<bool()> abandoned{};    ///< asked between FRFs: nobody waits for the fit any longer, and Interrupted is thrown
};

/// A mode and how well it is known.
struct Mode {
  Pole pole;
  double frequency_deviation_hz = 0.0;  ///< standard deviation, the scatter between FRFs included (PoleScatter)
  double damping_deviation = 0.0;
  double significance = 0.0;  ///< growth of the cost without it over what noise would reach
  double scatter = 1.0;       ///< factor on the frequency's standard deviation beyond what noise explains (PoleScatter)
  std::array<double, 2> own_hz{};  ///< lowest and highest of the frequencies by single FRFs (of those that the poles were refined with)
  bool inside = true;         ///< false: beyond the ends of the range, where its flank is better than a constant residual term
};

/// A pole–residue model of all FRFs of a set.
struct ModalFit {
  Status status = Status::ok;
  std::string message;
  std::vector<std::string> remarks;     ///< what was merged, left out or left over, one sentence each
  ModelKind kind;
  std::vector<frf::Dof> response, reference;
  std::vector<Mode> modes;              ///< ascending frequencies; first and last may be outside the range
  std::vector<double> peaks_left_hz;    ///< peaks of the residual FRFs that no pole would take
  std::vector<double> pole_covariance;  ///< [2N,2N] of (ln f, damping), row-major
  double scale_hz = 1.0;                ///< of the basis
  Residues residues;                    ///< of all entries, response by response
  std::vector<OrderPoles> stabilisation;
  bool known_noise = false;             ///< false: estimated from neighbouring lines
  double cost = 0.0, freedom = 0.0;     ///< of the FRFs that the poles were refined with
  double deviation = 0.0;               ///< rms residual of these FRFs over their moduli, weighted
  std::size_t refined_entries = 0, iterations = 0;

  std::vector<Pole> poles() const;
  std::size_t modes_inside() const;
};

/// Whether a pole lies between the first and the last line.
bool is_inside(const Pole& pole, const Band& band);

}  // namespace jointid::modalfit
