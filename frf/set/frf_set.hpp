#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/complex.hpp"
#include "frf/set/covariance_factor.hpp"
#include "frf/set/dof.hpp"
#include "frf/set/quantity.hpp"

namespace jointid::frf {

/// Unit vectors along X, Y and Z of a local system, in global axes.
using Axes = std::array<std::array<double, 3>, 3>;

inline constexpr Axes global_axes{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};

struct Node {
  std::int64_t id = 0;
  std::array<double, 3> position{};  ///< m, global axes
  std::optional<Axes> axes{};        ///< directions of the X, Y and Z of its DOFs; empty: the global ones. NaN: not known
};

/// Whether DOFs of some node are not along the global axes.
bool any_own_axes(const std::vector<Node>& nodes);

/// Information of a file about the noise of its FRFs.
enum class NoiseRecord : std::uint8_t { none, variance, coherence };

/// Information about an FRF set before any FRF is read.
struct FrfHeader {
  std::string file;                  ///< its origin, for messages
  std::vector<double> frequency_hz;  ///< [F] finite, ≥ 0, strictly increasing
  std::vector<Dof> response;         ///< [R] no coordinate twice
  std::vector<Dof> reference;        ///< [C] no coordinate twice
  Quantity quantity = Quantity::receptance;  ///< as stored; values are handed out as receptance
  NoiseRecord noise = NoiseRecord::none;
  double averages = 0.0;  ///< number of averages of coherences or variances, 0 if not known
  std::size_t repeats = 0;  ///< number of runs whose scatter gave the variances, 0 if none
  double precision = 0x1p-53;  ///< largest relative rounding error of the stored numbers
  std::vector<Node> nodes;
  std::vector<std::string> changes;  ///< corrections on reading, one phrase each (corrected())
  std::vector<std::string> doubts;   ///< doubtful points of the file, one phrase each

  std::size_t lines() const { return frequency_hz.size(); }
  std::size_t entries() const { return response.size() * reference.size(); }
};

/// Throws InputError (data) with a place of the file of the header.
[[noreturn]] void fail(const FrfHeader& header, std::string place, std::string problem, std::string remedy);

/// Throws InputError (data) unless the axis is finite, non-negative and strictly increasing. There must be at least one line,
/// response and reference; no coordinate appears twice among the responses or the references.
void validate(const FrfHeader& header);

/// Index of `dof`'s coordinate in `dofs`, whatever the signs, or npos.
inline constexpr std::size_t npos = static_cast<std::size_t>(-1);
std::size_t find_coordinate(const std::vector<Dof>& dofs, const Dof& dof);
inline bool has(const std::vector<Dof>& dofs, const Dof& dof) { return find_coordinate(dofs, dof) != npos; }

/// An FRF set in memory. Values are receptance in SI units, NaN where not measured. Element (line, r, c) is at (line·R
/// + r)·C + c. `variance` holds the variances of real and imaginary part as a complex number. It and `coherence` are
/// empty or as long as `values`. `covariance` is that of the errors e of one line and reference over the responses,
/// E[e_r e_s*] for s ≤ r, at (line·P + pair_index(r, s))·C + c with P = pair_count(R). It is in addition to
/// `variance`. Errors are taken as circular, E[e_r e_s] = 0. If `variance` differs between real and imaginary part,
/// its sum is the diagonal of the covariance. `factor` can replace `covariance`. `reference_correlation` ρ is the
/// correlation between references, as of forces that act at once; Hermitian with a diagonal of 1: E[e_rm e_sn*] = ρ_mn
/// (K_m K_nᴴ)_rs of references m and n, K_m the lower Cholesky factor of the covariance of m. Without it references
/// are independent.
struct FrfSet {
  FrfHeader header;
  std::vector<Complex> values;     ///< [F,R,C]
  std::vector<Complex> variance;   ///< [F,R,C] or empty, of the receptance
  std::vector<double> coherence;   ///< [F,R,C] or empty
  std::vector<Complex> covariance{};  ///< [F,P,C] or empty, of the receptance
  CovarianceFactor factor{};          ///< in place of `covariance` if smaller
  std::vector<Complex> reference_correlation{};  ///< [F,C,C] or empty, beside covariances

  bool has_covariance() const { return !covariance.empty() || factor.any(); }

  std::size_t index(std::size_t line, std::size_t r, std::size_t c) const {
    return (line * header.response.size() + r) * header.reference.size() + c;
  }
};

/// Number of pairs (r, s), s ≤ r, of R responses, and the index of one: the lower triangle row by row.
constexpr std::size_t pair_count(std::size_t responses) { return responses * (responses + 1) / 2; }
constexpr std::size_t pair_index(std::size_t r, std::size_t s) { return pair_count(r) + s; }

/// Throws InputError (data) as validate() of the header. Also if values, variance, coherence or covariance have another
/// length than the header implies, if there are both covariances and a factor, or a correlation of references without
/// covariances.
void validate(const FrfSet& set);

}  // namespace jointid::frf
