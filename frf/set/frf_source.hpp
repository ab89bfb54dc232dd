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

/// What a source was asked to hand out so far; tests and the plan hold promises against it.
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

/// The errors of the FRFs of a line as sums of independent ones of unit variance, e = Σ factor · ε with E|ε|² = 1: what FRFs that were
/// worked out of the same ones have in common, those of different references too.
struct ErrorSums {
  struct Term {
    std::size_t error;
    Complex factor;
    double relation = 0.0;  ///< E[ε²], real: 0 where the error is circular, ±1 where it is real or imaginary alone
  };
  std::size_t errors = 0;                ///< how many ε there are
  std::vector<std::vector<Term>> terms;  ///< [response, reference] of a block; none where an FRF is exact or not measured
};

/// A file (or a set in memory) from which lines and blocks are read. The header is read on opening, FRFs only when
/// asked for. Values come as receptance in SI units for the header's DOFs as they stand there (signs included),
/// NaN where not measured, in the order [line, response, reference] of the block.
/// Sources are not thread-safe; open one per thread.
class FrfSource {
 public:
  virtual ~FrfSource() = default;
  FrfSource(const FrfSource&) = delete;
  FrfSource& operator=(const FrfSource&) = delete;

  const FrfHeader& header() const { return header_; }
  const ReadCount& count() const { return count_; }

  /// Reads block.size() values into `out`. Throws InputError when the file breaks its own promises.
  void read(const Block& block, std::span<Complex> out);

  /// Variances of the receptances (real and imaginary part); only when header().noise == variance.
  void read_variance(const Block& block, std::span<Complex> out);

  /// Coherences; only when header().noise == coherence.
  void read_coherence(const Block& block, std::span<double> out);

  /// Whether there are covariances between the FRFs of a line and reference. Nothing of them is read unless read_covariance() asks;
  /// sources that join files or take masses off have none.
  virtual bool has_covariance() const { return false; }

  /// For every line and reference of the block the Hermitian matrix E[e_i e_k*] of the errors of the receptances of
  /// block.responses: out[((line · C + c) · R + i) · R + k], block.size() · R values. NaN where not known. Only when
  /// has_covariance(). Throws InputError where a diagonal element is below 0 or not real.
  void read_covariance(const Block& block, std::span<Complex> out);

  /// All of them of some lines as they are stored, [line, pair, reference], as FrfSet::covariance.
  void read_covariance_pairs(std::span<const std::size_t> lines, std::span<Complex> out);

  /// Whether the errors of FRFs to different references have something in common (FrfSet::reference_correlation); only beside
  /// covariances.
  virtual bool has_reference_correlation() const { return false; }

  /// Of some lines and references, out[(line · n + i) · n + k] of the i-th and k-th of n references. NaN where not known. Only
  /// when has_reference_correlation(). Throws InputError where it is no correlation: a diagonal other than 1, an element above 1
  /// or not the conjugate of its mirror image.
  void read_reference_correlation(std::span<const std::size_t> lines, std::span<const std::size_t> references,
                                  std::span<Complex> out);

  /// Whether FRFs are worked out of others and the source says which errors they share: coupled ones, with variances.
  virtual bool has_error_sums() const { return false; }

  /// L and d of covariances that are L Lᴴ + diag(d); rank 0 where they are stored as pairs, or not at all. Whoever asks for covariances
  /// does not see the difference.
  virtual FactorShape factor_shape() const { return {}; }

  /// Of a block: `rows` [line, response, column of L, reference], and `diagonal` [line, response, reference] where the shape has one,
  /// else empty. Only of a rank above 0. Throws InputError where d is below 0 or infinite, or part of what there is of an FRF is NaN.
  void read_factor(const Block& block, std::span<Complex> rows, std::span<double> diagonal);

  /// Of every line of the block, whose ε have nothing to do with those of another line or call. Only when has_error_sums().
  std::vector<ErrorSums> read_error_sums(const Block& block);

  /// Whether all values lie in memory already.
  virtual bool in_memory() const { return false; }

 protected:
  FrfSource() = default;
  virtual void do_read(const Block& block, std::span<Complex> out) = 0;
  virtual void do_read_variance(const Block& block, std::span<Complex> out) = 0;
  virtual void do_read_coherence(const Block& block, std::span<double> out) = 0;
  /// `pairs` is a block whose responses are pair indices, each once and ascending. Without more they are formed of the factor.
  virtual void do_read_covariance(const Block& pairs, std::span<Complex> out);
  virtual void do_read_factor(const Block& block, std::span<Complex> rows, std::span<double> diagonal);
  virtual std::vector<ErrorSums> do_read_error_sums(const Block& block);
  virtual void do_read_reference_correlation(std::span<const std::size_t> lines, std::span<const std::size_t> references,
                                             std::span<Complex> out);
  /// do_read_covariance() of another source, for one that hands it on.
  static void read_pairs(FrfSource& of, const Block& pairs, std::span<Complex> out) { of.do_read_covariance(pairs, out); }

  FrfHeader header_;

 private:
  void form_pairs(const Block& pairs, std::span<Complex> out);

  ReadCount count_;
};

/// What the user knows of a file and the file does not say; each is an error to leave out only where it is needed. A quantity is
/// taken even where the file says another.
struct OpenOptions {
  /// Of a universal file without FRFs, the spectra (function type 12) instead: those of motions, or of forces.
  enum class Spectra : std::uint8_t { none, motions, forces };

  std::optional<Quantity> quantity;  ///< for files that do not name it (UFF types 0/1, MAT, CSV), or name a wrong one
  std::string unit;                  ///< of the FRFs, e.g. "g/lbf", in place of what the file says of it; empty: as the file says
  std::vector<Dof> response;         ///< for matrices without DOFs (MAT, CSV), and for records without directions (UFF)
  std::vector<Dof> reference;        ///< default: as the responses, when the matrix is square
  std::string variable;              ///< files of named arrays (MAT, HDF5, npz): the FRFs, S.field of a struct
  std::string frequency_variable{};  ///< the same of the frequencies; of .npy the file that holds them
  std::string frequency_unit{};      ///< of the frequencies, e.g. "kHz", in place of what the file says of it
  Spectra spectra = Spectra::none;   ///< other formats do not tell them from FRFs
};

/// Opens by content, not by name: jointid-frf HDF5, UFF, MATLAB v5/v7/v7.3 or CSV. Throws InputError naming what was
/// found when it is none of them.
std::unique_ptr<FrfSource> open(const std::filesystem::path& path, const OpenOptions& options = {});

/// A set in memory as a source (tests, studies, formats that load whole).
std::unique_ptr<FrfSource> from_memory(FrfSet set);

/// A set that the caller keeps: what is in it when a block is read is handed out. Its header must not change.
std::unique_ptr<FrfSource> from_shared(std::shared_ptr<const FrfSet> set);

/// The whole of a source in memory, but for covariances.
FrfSet load(FrfSource& source);

/// The same with them, where there are any, as they are stored.
FrfSet load_with_covariance(FrfSource& source);

/// FrfSet::covariance of a set, formed of the factor where it has that; empty where it has neither.
std::vector<Complex> covariance_pairs(const FrfSet& set);

/// A part of a source in memory, as a set of its own.
FrfSet load(FrfSource& source, const Block& block);

}  // namespace jointid::frf
