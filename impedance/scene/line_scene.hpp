#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ident/scene/scene.hpp"
#include "impedance/law/law.hpp"
#include "impedance/smooth/spline.hpp"

namespace jointid::impedance {

/// Which elements of Z_J are unknown at a line.
enum class Structure {
  symmetric,  ///< all of a symmetric matrix
  diagonal,
  massless,  ///< T z Tᵀ between facing halves, T = [I; −I], z symmetric
  masses,    ///< the same, and a term of its own at each diagonal element
  given      ///< a matrix of names or springs
};

std::string name(Structure structure);

/// Whether its DOFs face each other in pairs.
bool has_halves(Structure structure);

/// How Z_J is found at a line; (n) are the equations of docs/joint-line-by-line.md.
enum class Way {
  likelihood,
  weighed,       ///< (9): blocks of (1), weighed by their covariance
  primal,        ///< (1)
  dual,          ///< (5)
  average,       ///< (3)
  off_diagonal,  ///< (2)
  relative,      ///< (4)
  extended,      ///< (6), rows and columns at the joint and away from it
  nj,            ///< (7)
  nn             ///< (8)
};

/// "likelihood", "off-diagonal", …
std::string name(Way way);
const std::vector<std::string>& way_names();

/// A scene whose [joint] has `lines`.
struct LineScene {
  /// Its joint has K and D of the structure: at one line K + iD is Z. Method likelihood, which no solution is asked of.
  ident::Scene scene;
  Structure structure = Structure::symmetric;
  std::vector<std::pair<std::size_t, std::size_t>> facing;  ///< joint coordinates of both halves; empty unless massless or masses
  std::vector<Way> ways = {Way::likelihood};                ///< the first is the result
  std::vector<LawKind> laws;                                ///< fitted to the result; empty: none
  bool law_per_joint = false;                               ///< elements share all of a law but their stiffness
  std::optional<Smoothing> smoothing;                       ///< of the result over lines; empty: none
  double lambda = 0.0;                                      ///< where it is given
  std::size_t splines = 0;                                  ///< 0: a third of the lines, 12 to 40
  bool law_masses = false;                                  ///< masses of the joint's DOFs are unknowns beside the law
};

/// Makes one of a scene with data whose joint's DOFs are there: matrices of the structure, checks of `facing`. Throws InputError
/// (usage).
void set_structure(LineScene& scene);

}  // namespace jointid::impedance
