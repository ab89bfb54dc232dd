#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "ident/variance/noise_laws.hpp"
#include "ident/plan/plan.hpp"
#include "ident/result/suspect.hpp"
#include "ident/variance/covariance_law.hpp"

namespace jointid::ident {

/// 0, 1, … count − 1.
std::vector<std::size_t> all_indices(std::size_t count);

/// Places of the lines in the scene's range, at most so many, evenly spread; none at 0 Hz.
std::vector<std::size_t> lines_in_range(const Scene& scene, const std::vector<double>& frequency_hz, std::size_t most);

/// Of a file that was opened, as the scene names it.
std::string name_in_scene(const Scene& scene, const std::string& file);

/// The FRFs of one file at the lines of a check, for DOFs of positive sign. Rows and columns without a number are left out.
struct CheckedFile {
  std::string name;  ///< as the scene names it
  bool assembly = false;
  frf::Quantity quantity = frf::Quantity::receptance;  ///< as stored
  std::optional<double> mass{};                        ///< kg, as the scene says
  Dofs responses, references;
  std::vector<double> frequency_hz;    ///< [F]
  std::vector<Eigen::MatrixXcd> frfs;  ///< [F] receptances, responses × references; NaN where not measured
  /// Law of the errors' covariances over the responses, of all lines and references; none where the file has none.
  std::shared_ptr<const CovarianceLaw> errors{};
  std::vector<Suspect> wild{};  ///< numbers far out of their neighbours (frf::WildSearch); of consecutive lines
  std::shared_ptr<const NoiseLaws> noise{};  ///< of each FRF; null where the file knows nothing
  /// Exact recorded E|e|² (recorded_squares()) over that of the law where it is larger, else 1; empty where they are not exact. [F]
  /// responses × references
  std::vector<Eigen::MatrixXd> recorded_over_law{};

  /// Whether the file says how large its noise is.
  bool has_recorded_noise() const { return errors != nullptr || noise != nullptr; }
  /// E[e e^H] of some FRFs of a line to a reference. Only with `errors`.
  Eigen::MatrixXcd covariance(std::size_t line, const std::vector<Eigen::Index>& some_responses, Eigen::Index reference) const;
  /// One of its diagonal.
  double variance(std::size_t line, Eigen::Index response, Eigen::Index reference) const;
  /// E|e|² of one FRF by the laws, or as recorded where exact variances are larger; NaN where it is not known.
  double error_square(std::size_t line, Eigen::Index response, Eigen::Index reference) const;
};

/// What is read of a scene.
struct CheckedSystems {
  const Scene& scene;
  frf::FrfSystem& substructures;
  frf::FrfSystem& assembly;
  const std::vector<Line>& lines;
};

/// How much is read at most.
struct CheckExtent {
  std::size_t lines;
  std::size_t values = 4'000'000;  ///< complex numbers of all files together, 64 MB
};

/// Reads every file once, at some of its lines, evenly spread; two at least.
std::vector<CheckedFile> read_checked_files(const CheckedSystems& of, const CheckExtent& most,
                                            const std::function<bool()>& interrupted);

/// The file at some of its lines.
CheckedFile at_lines(const CheckedFile& file, const std::vector<std::size_t>& lines);

/// The file's FRFs between some of the coordinates that it has.
CheckedFile part_of(const CheckedFile& file, const Dofs& responses, const Dofs& references);

/// Channels without signal (the rms of their FRFs is below 1e-4 of the median of their kind) and channels that repeat another of
/// the file (to 1e-6). They are taken out of the file.
std::vector<Suspect> take_out_dead_and_copied(CheckedFile& file);

/// The index of a coordinate, or frf::npos.
inline std::size_t place_of(const Dofs& dofs, const frf::Dof& dof) { return frf::find_coordinate(dofs, dof); }

}  // namespace jointid::ident
