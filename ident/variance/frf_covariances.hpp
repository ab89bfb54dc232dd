#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "base/complex.hpp"
#include "frf/set/frf_system.hpp"
#include "ident/scene/scene.hpp"
#include "ident/variance/covariance_law.hpp"

namespace jointid::ident {

/// The error of an FRF of a rectangle as that of a stored one: `sign` times the error of row `member` of covariance `group`.
struct StoredError {
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::size_t group = none, member = 0;
  double sign = 1.0;

  bool is_known() const { return group != none; }
};

/// Covariances of the measured FRFs of one system over some coordinates: a group is the FRFs of one file to one reference, or to
/// all of them where the file says what these have in common; errors of different groups are independent. Taken from files that
/// have covariances and whose variances count (variance_origin()); where those come from few averages by a CovarianceLaw over all
/// lines, as variances are (smoothed_laws()), else as the file has them.
class FrfCovariances {
 public:
  /// Rows and columns of a part of the coordinates that is read.
  struct Rectangle {
    std::vector<std::size_t> rows, columns;
  };

  FrfCovariances(frf::FrfSystem& system, const Scene& scene, const std::vector<frf::Dof>& coordinates,
                 const std::vector<Rectangle>& rectangles);

  bool any() const { return !groups_.empty(); }

  /// Fits the laws over these common lines: before read(), and again when the FRFs have changed.
  void prepare(std::span<const std::size_t> lines);

  /// Reads some common lines (ascending).
  void read(std::span<const std::size_t> lines);

  /// Of the i-th line read: covariance of each group, receptances, NaN where not known.
  const std::vector<Eigen::MatrixXcd>& covariances(std::size_t i) const { return covariances_[i]; }

  /// Of the i-th line read: whose error the FRF (row, column) has; none where its file has no covariance.
  StoredError error(std::size_t i, std::size_t row, std::size_t column) const;

  /// Whether its variance is that of the law, the diagonal of the group's covariance.
  bool by_law(const StoredError& error) const {
    const Column& first = columns_[groups_[error.group].front()];
    return columns_[groups_[error.group][error.member / first.responses.size()]].law.constant.size() > 0;
  }

 private:
  /// FRFs of a file to one reference.
  struct Column {
    std::size_t source, reference;
    std::vector<std::size_t> responses;  ///< the same in all columns of a group
    bool by_law;
    CovarianceLaw law;
  };
  /// FRF `member` of a column of a group.
  struct StoredFrf {
    std::size_t group = StoredError::none, column = 0, member = 0;
    double sign = 1.0;
  };
  /// The stored FRF of a place, and that of the transposed one, which stands in for it where it was not measured (reciprocity).
  struct Place {
    StoredFrf direct, mirrored;
  };

  void add(const frf::BlockPiece& piece, const FrfCovariances::Rectangle& rectangle, bool by_law);
  StoredFrf stored(std::size_t source, std::size_t response, std::size_t reference, bool by_law);
  std::size_t group_of(std::size_t source);
  Eigen::MatrixXcd joined(const std::vector<std::size_t>& group, std::span<const Complex> correlation,
                          const std::vector<Eigen::MatrixXcd>& of_column) const;
  std::vector<std::size_t> source_lines(std::size_t source, std::span<const std::size_t> lines) const;

  frf::FrfSystem& system_;
  std::size_t size_;
  std::vector<Column> columns_;
  std::vector<std::vector<std::size_t>> groups_;  ///< columns of each
  std::vector<Place> places_;  ///< [row, column]
  std::vector<std::vector<Eigen::MatrixXcd>> covariances_;  ///< [line][group]
  std::vector<std::vector<std::vector<bool>>> measured_;    ///< the same, [member]
};

}  // namespace jointid::ident
