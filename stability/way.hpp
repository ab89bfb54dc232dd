#pragma once

#include <string>
#include <variant>

#include "ident/scene/method_traits.hpp"

namespace jointid::stability {

/// Ways to solve rows that are measured beside the solvers of scenes.
enum class OwnWay {
  svd,        ///< solve_svd()
  qr_refined  ///< solve_refined(); of rows that are no scene's alone
};

/// A solver of scenes, or a way of this folder.
using Way = std::variant<ident::Solver, OwnWay>;

/// "qr", "svd", "qr refined".
inline std::string name(Way way) {
  if (const auto* solver = std::get_if<ident::Solver>(&way)) return ident::name(*solver);
  return std::get<OwnWay>(way) == OwnWay::svd ? "svd" : "qr refined";
}

}  // namespace jointid::stability
