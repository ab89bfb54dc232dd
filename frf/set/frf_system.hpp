#pragma once

#include <memory>
#include <span>
#include <vector>

#include "frf/set/block_pieces.hpp"
#include "frf/set/frf_source.hpp"
#include "frf/set/kept_source.hpp"

namespace jointid::frf {

/// How several files make one system.
enum class Composition {
  uncoupled,  ///< each file is a structure of its own: FRFs across two files are zero by construction
  merged      ///< the files hold parts of one structure's FRF matrix: what no file holds is not measured
};

/// Two lines are the same when they differ by at most this share of the smaller line spacing (UFF rounds increments).
inline constexpr double axis_tolerance = 0.1;

/// "400 to 1000 Hz in 31 lines", for messages.
std::string range_text(const std::vector<double>& axis);

/// For each line of `axis` the line of `other` that is the same, or npos.
std::vector<std::size_t> match_lines(const std::vector<double>& axis, const std::vector<double>& other);

/// One or several files as one FRF matrix over the frequency lines that all of them have.
class FrfSystem {
 public:
  /// `name` ("substructures", "assembly") is for messages. Throws InputError (data) when no line is common to all files,
  /// or a coordinate (uncoupled) or an FRF (merged) stands in two of them.
  FrfSystem(std::string name, std::vector<std::unique_ptr<FrfSource>> sources, Composition composition,
            bool use_reciprocity);

  const std::string& name() const { return name_; }
  const std::vector<double>& frequency_hz() const { return frequency_hz_; }
  std::size_t lines_without_partner() const { return lines_without_partner_; }

  /// All coordinates that are a response (reference) in some file; with reciprocity either role will do.
  const std::vector<Dof>& responses() const { return responses_; }
  const std::vector<Dof>& references() const { return references_; }

  /// Every FRF that is read from now on is kept, up to so many bytes, and read once (KeptSource).
  void keep(std::size_t bytes);

  std::size_t source_count() const { return sources_.size(); }
  const FrfSource& source(std::size_t index) const { return *sources_[index]; }
  FrfSource& source(std::size_t index) { return *sources_[index]; }
  /// The line of that source which is the common line `line`.
  std::size_t source_line(std::size_t index, std::size_t line) const { return source_lines_[index][line]; }
  /// The pieces that make the rectangle rows × columns: the files' own FRFs first, then with reciprocity their transposes.
  std::vector<BlockPiece> pieces(const std::vector<Dof>& rows, const std::vector<Dof>& columns) const;
  /// A line of the rectangle before any FRF is read: zero across two uncoupled files, NaN elsewhere.
  std::vector<Complex> background(const std::vector<Dof>& rows, const std::vector<Dof>& columns) const;
  /// The file that holds the coordinate in either role, or npos.
  std::size_t source_of(const Dof& dof) const;

 private:
  friend class BlockReader;
  void align_axes();
  void collect_coordinates();
  void require_disjoint() const;

  std::string name_;
  std::vector<std::unique_ptr<FrfSource>> sources_;
  std::vector<KeptSource*> files_;  ///< of sources_, those that are not in memory
  Composition composition_;
  bool use_reciprocity_;
  std::vector<double> frequency_hz_;
  std::vector<std::vector<std::size_t>> source_lines_;  ///< [source][common line] → line of the source
  std::size_t lines_without_partner_ = 0;
  std::vector<Dof> responses_, references_;
};

/// Reads one rectangle rows × columns of a system, line by line. FRFs carry the signs of the DOFs asked for.
class BlockReader {
 public:
  BlockReader(FrfSystem& system, const std::vector<Dof>& rows, const std::vector<Dof>& columns);

  std::size_t rows() const { return rows_; }
  std::size_t columns() const { return columns_; }

  /// Fills out[line, row, column] for the given common lines (ascending). NaN where nothing was measured.
  void read(std::span<const std::size_t> lines, std::span<Complex> out);

 private:
  bool is_plain() const;
  void scatter(const BlockPiece& piece, std::size_t lines, std::span<Complex> out) const;

  FrfSystem& system_;
  std::size_t rows_, columns_;
  std::vector<BlockPiece> pieces_;
  std::vector<Complex> background_;  ///< FrfSystem::background()
  std::vector<Complex> scratch_;
  std::vector<std::size_t> source_lines_;
};

/// A system of sets in memory.
std::unique_ptr<FrfSystem> memory_system(std::string name, std::vector<FrfSet> sets, Composition composition, bool reciprocity = false);

}  // namespace jointid::frf
