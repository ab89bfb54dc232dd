#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ident/result/solution.hpp"
#include "tasks/regenerate.hpp"

namespace jointid::tasks {

/// What is asked of a solution before its numbers are used.
enum class WorthQuestion : std::uint8_t {
  determined,       ///< do the data determine every unknown?
  passive,          ///< can springs, dampers and masses be this joint?
  noise,            ///< does the noise explain what the joint leaves?
  better_than_none  ///< are the FRFs of the assembly nearer to the measured ones than without a joint?
};

enum class Light : std::uint8_t { good, doubtful, bad, unknown };

/// Element of a joint matrix: index into Solution::bands and Solution::dofs.
struct MatrixElement {
  std::size_t band = 0;
  restrictions::Kind kind = restrictions::Kind::stiffness;
  std::size_t row = 0, column = 0;
};

/// An answer, and the place where it is seen.
struct WorthAnswer {
  WorthQuestion question = WorthQuestion::determined;
  Light light = Light::unknown;
  std::string text{};                     ///< a sentence
  std::string unknown{};                  ///< of `determined`: the least determined one
  std::optional<MatrixElement> element{};  ///< of `passive`: the diagonal element with most motion
  std::optional<FrfEntry> frf{};          ///< of the last two: the FRF with the largest error among those compared
};

/// The answers in the order of the questions. Reads up to nine FRFs of the assembly, and what synthesises them. Throws InputError, and
/// Interrupted.
std::vector<WorthAnswer> worth(const ident::Plan& plan, const ident::Solution& solution, const ident::Control& control = {});

}  // namespace jointid::tasks
