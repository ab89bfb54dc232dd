#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "frf/set/frf_set.hpp"

namespace jointid::frf {

/// Data that a source has delivered so far. Tests and the plan compare it with promises.
struct ReadCount {
  std::size_t calls = 0;
  std::size_t lines = 0;    ///< lines handed out, summed over calls
  std::size_t entries = 0;  ///< complex FRF values handed out
};

/// A block of an FRF set: every combination of the given lines, responses and references (header indices).
struct Block {
  std::span<const std::size_t> lines;       ///< ascending
  std::span<const std::size_t> responses;   ///< any order
  std::span<const std::size_t> references;  ///< any order

  std::size_t size() const { return lines.size() * responses.size() * references.size(); }
};

/// Errors of the FRFs of a line as sums of independent errors of unit variance, e = Σ factor · ε with E|ε|² = 1. They give the
/// correlation of FRFs that were computed from the same ones, also of different references.
struct ErrorSums {
  struct Term {
    std::size_t error;
    Complex factor;
    double relation = 0.0;  ///< E[ε²], real: 0 for a circular error, ±1 for a real or imaginary one
  };
  std::size_t errors = 0;                ///< number of ε
  std::vector<std::vector<Term>> terms;  ///< [response, reference] of a block; none if an FRF is exact or not measured
};

/// A file (or a set in memory) from which lines and blocks are read. Opening reads the header; FRFs are read
/// on request. Values are receptances in SI units for the header's DOFs with their signs, NaN where not
/// measured, in the order [line, response, reference] of the block. Sources are not thread-safe; open one per
/// thread.
class FrfSource {
 public:
  virtual ~FrfSource() = default;
  FrfSource(const FrfSource&) = delete;
  FrfSource& operator=(const FrfSource&) = delete;

  const FrfHeader& header() const { return header_; }
  /// Positions of nodes, in place of those that the file states of the same ones.
  void place_nodes(const std::vector<Node>& nodes);
  const ReadCount& count() const { return count_; }

  /// Reads block.size() values into `out`. Throws InputError if the file contradicts its header.
  void read(const Block& block, std::span<Complex> out);

  /// Variances of the receptances (real and imaginary part); only when header().noise == variance.
  void read_variance(const Block& block, std::span<Complex> out);

  /// Coherences; only when header().noise == coherence.
  void read_coherence(const Block& block, std::span<double> out);

  /// Whether there are covariances between the FRFs of a line and reference. Only read_covariance() reads them. Sources that join
  /// files or remove sensor masses have none.
  virtual bool has_covariance() const { return false; }

  /// For every line and reference of the block the Hermitian matrix E[e_i e_k*] of the errors of the receptances of
  /// block.responses: out[((line · C + c) · R + i) · R + k], block.size() · R values. NaN where not known. Only if
  /// has_covariance(). Throws InputError for a diagonal element that is below 0 or not real.
  void read_covariance(const Block& block, std::span<Complex> out);

  /// All covariances of some lines as stored, [line, pair, reference], as FrfSet::covariance.
  void read_covariance_pairs(std::span<const std::size_t> lines, std::span<Complex> out);

  /// Whether errors of FRFs to different references are correlated (FrfSet::reference_correlation). Only with
  /// covariances.
  virtual bool has_reference_correlation() const { return false; }

  /// Of some lines and references, out[(line · n + i) · n + k] for the i-th and k-th of n references. NaN where not known. Only
  /// if has_reference_correlation(). Throws InputError for a diagonal other than 1, an element above 1, or a matrix that is not
  /// Hermitian.
  void read_reference_correlation(std::span<const std::size_t> lines, std::span<const std::size_t> references,
                                  std::span<Complex> out);

  /// Whether FRFs are computed from others, with variances, and the source states the errors that they share (coupled FRFs).
  virtual bool has_error_sums() const { return false; }

  /// L and d of covariances L Lᴴ + diag(d). Rank 0 if they are stored as pairs, or not at all. Callers of read_covariance() see
  /// no difference.
  virtual FactorShape factor_shape() const { return {}; }

  /// Of a block: `rows` [line, response, column of L, reference], and `diagonal` [line, response, reference] if the shape has
  /// one, else empty. Only for a rank above 0. Throws InputError if d is below 0 or infinite, or if an FRF is NaN in part.
  void read_factor(const Block& block, std::span<Complex> rows, std::span<double> diagonal);

  /// Error sums of every line of the block. The ε of different lines or calls are independent. Only if has_error_sums().
  std::vector<ErrorSums> read_error_sums(const Block& block);

  /// Whether all values are in memory already.
  virtual bool in_memory() const { return false; }

 protected:
  FrfSource() = default;
  virtual void do_read(const Block& block, std::span<Complex> out) = 0;
  virtual void do_read_variance(const Block& block, std::span<Complex> out) = 0;
  virtual void do_read_coherence(const Block& block, std::span<double> out) = 0;
  /// `pairs` is a block whose responses are pair indices, each once and ascending. By default they are formed from the factor.
  virtual void do_read_covariance(const Block& pairs, std::span<Complex> out);
  virtual void do_read_factor(const Block& block, std::span<Complex> rows, std::span<double> diagonal);
  virtual std::vector<ErrorSums> do_read_error_sums(const Block& block);
  virtual void do_read_reference_correlation(std::span<const std::size_t> lines, std::span<const std::size_t> references,
                                             std::span<Complex> out);
  /// do_read_covariance() of another source, for a source that passes it on.
  static void read_pairs(FrfSource& of, const Block& pairs, std::span<Complex> out) { of.do_read_covariance(pairs, out); }

  FrfHeader header_;

 private:
  void form_pairs(const Block& pairs, std::span<Complex> out);

  ReadCount count_;
};

/// Information of the user about a file. It may be left out unless the file lacks it. A quantity given here overrides that of the
/// file.
struct OpenOptions {
  /// For a universal file without FRFs: the spectra (function type 12) instead, those of motions or of forces.
  enum class Spectra : std::uint8_t { none, motions, forces };

  std::optional<Quantity> quantity;  ///< for files without a quantity (UFF types 0/1, MAT, CSV), or with a wrong one
  std::string unit;                  ///< of the FRFs, e.g. "g/lbf", in place of the file's; empty: that of the file
  std::vector<Dof> response;         ///< for matrices without DOFs (MAT, CSV), and for records without directions (UFF)
  std::vector<Dof> reference;        ///< default: as the responses, when the matrix is square
  std::string variable;              ///< files of named arrays (MAT, HDF5, npz): the FRFs, S.field of a struct
  std::string frequency_variable{};  ///< the same for the frequencies; for .npy the file with them
  std::string frequency_unit{};      ///< of the frequencies, e.g. "kHz", in place of the file's
  Spectra spectra = Spectra::none;   ///< for formats that do not distinguish them from FRFs
};

/// Opens by content, not by name: jointid-frf HDF5, UFF, MATLAB v5/v7/v7.3 or CSV. Other content throws InputError that names
/// it.
std::unique_ptr<FrfSource> open(const std::filesystem::path& path, const OpenOptions& options = {});

/// A set in memory as a source (tests, studies, formats that load whole).
std::unique_ptr<FrfSource> from_memory(FrfSet set);

/// A set that the caller keeps. Each block has the set's values at the time of reading. Its header must not change.
std::unique_ptr<FrfSource> from_shared(std::shared_ptr<const FrfSet> set);

/// A whole source in memory, without covariances.
FrfSet load(FrfSource& source);

/// A whole source in memory, with covariances as stored.
FrfSet load_with_covariance(FrfSource& source);

/// FrfSet::covariance of a set, formed from the factor if it has one; empty if it has neither.
std::vector<Complex> covariance_pairs(const FrfSet& set);

/// A part of a source in memory, as a set.
FrfSet load(FrfSource& source, const Block& block);

}  // namespace jointid::frf
