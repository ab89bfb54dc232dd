#pragma once

#include "minimise/blocks.hpp"
#include "minimise/least_squares.hpp"

namespace jointid::minimise {

/// What the modules of this folder implement (base/module.hpp): the functions of least_squares.hpp and blocks.hpp of these names.
class CeresModule {
 public:
  virtual ~CeresModule() = default;
  virtual Minimum minimum(const LeastSquares& problem, std::span<const double> start, const CeresOptions& options) = 0;
  virtual BlockMinimum blocks(const std::vector<BlockTerm>& terms, const BlockOptions& options) = 0;
};

class IpoptModule {
 public:
  virtual ~IpoptModule() = default;
  virtual Minimum minimum(const LeastSquares& problem, std::span<const double> start, const IpoptOptions& options) = 0;
};

}  // namespace jointid::minimise
