#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>

#include "models/model_use.hpp"

namespace jointid::models {

/// H_kk |Z_kk| from which on a receptance is infinite to rounding.
inline constexpr double infinite_receptance = 1e13;

/// What a model was asked to compute so far; tests hold promises against it.
struct ModelCount {
  std::size_t factorizations = 0;  ///< of dynamic stiffnesses
  std::size_t columns = 0;         ///< of receptances, one for each unit force that was applied
  std::size_t reduced = 0;         ///< lines that a reduced basis gave, without a factorisation
};

/// A linear structure without measurement: its receptance at any frequency.
class Model {
 public:
  Model() = default;
  virtual ~Model() = default;
  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;

  /// Number of coordinates.
  virtual std::size_t size() const = 0;

  /// H(ω) in SI units between the coordinates `rows` and `columns`, ω ≥ 0 in rad/s, of e^{iωt}; nothing where it is infinite to
  /// rounding. What is not asked for is not computed.
  virtual std::optional<Eigen::MatrixXcd> receptance(double omega, std::span<const std::size_t> rows,
                                                     std::span<const std::size_t> columns) = 0;

  /// What will be asked for next, so that a model may prepare for all of it at once.
  struct Request {
    std::span<const double> omega;  ///< rad/s
    double lowest = 0.0, highest = 0.0;  ///< of all lines that there are, above 0
    std::span<const std::size_t> coordinates;
  };
  virtual void expect(const Request&) {}

  const ModelCount& count() const { return count_; }

  /// What was done so far, and what so many lines between so many coordinates will take.
  virtual ModelUse use(std::size_t lines, std::size_t coordinates) const = 0;

 protected:
  ModelCount count_;
};

}  // namespace jointid::models
