#pragma once

#include "coupling/line_coupler.hpp"
#include "coupling/part_reader.hpp"

namespace jointid::coupling {

/// Reads lines of an assembly: the FRFs of its parts, coupled. Nothing of the parts is kept but the lines in work.
class AssemblyReader {
 public:
  /// From the headers alone. `where` stands for the scene in messages. Throws InputError as make_layout() and validate(), for
  /// parts without a common line, for receptance coupling of what it cannot couple (rc_lacks()), for impedance coupling of
  /// results that are not square, and for variances that no file and no law has.
  AssemblyReader(std::vector<Part> parts, const Assembly& assembly, const Options& options, const std::string& where);

  /// Lines, DOFs, nodes and quantity of the result; noise is `variance` with Options::uncertainty.
  const frf::FrfHeader& header() const { return header_; }
  const Layout& layout() const { return layout_; }
  const Options& options() const { return options_; }
  std::size_t lines_without_partner() const { return lines_without_partner_; }

  /// Whether variances of the result come with covariances: some part has them (PartReader).
  bool has_covariance() const { return has_covariance_; }

  /// Fills values[line, response, reference] for a block of header(); `variance` as long as `values` or empty, `records` one per
  /// line or empty, `covariance` beside `variance` as FrfSet::covariance of the block, or empty.
  void read(const frf::Block& block, std::span<Complex> values, std::span<Complex> variance = {}, std::span<LineRecord> records = {},
            std::span<Complex> covariance = {});

  /// What makes the errors of the FRFs of a block, to first order, line by line. Only with Options::uncertainty. Covariances of files are
  /// drawn towards their diagonals by n/(n + degrees of freedom), n responses, lest few averages promise what they cannot know.
  std::vector<frf::ErrorSums> read_errors(const frf::Block& block);

 private:
  struct PartBlock;
  struct Work;
  struct LineInput;
  void match_axes();
  void make_header();
  void require_method(const std::string& where) const;
  Work plan_block(const frf::Block& block, bool with_variance) const;
  /// Where the results of a block go; empty: nobody asks.
  struct Results {
    std::span<Complex> values, variance, covariance;
    std::span<LineRecord> records;
    std::span<frf::ErrorSums> errors;
  };
  void read(const frf::Block& block, const Results& to);
  /// What a part gives to some lines of the result, one input each: its FRFs, and the variances that the work asks for.
  void read_part(PartBlock& part, const Work& work, std::span<const std::size_t> lines, std::span<LineInput> to) const;
  /// What the errors of a part's FRFs have in common with those of the joints, on one line.
  void place_common(const PartBlock& part, const Work& work, double frequency_hz, LineVariance& to) const;

  std::vector<Part> parts_;
  Options options_;
  Layout layout_;
  frf::FrfHeader header_;
  std::vector<std::vector<std::size_t>> part_line_;  ///< [part][line of the result] → line of the part
  std::size_t lines_without_partner_ = 0;
  bool has_covariance_ = false;
};

}  // namespace jointid::coupling
