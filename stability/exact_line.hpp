#pragma once

#include <cstddef>
#include <vector>

#include "base/eigen.hpp"
#include "frf/set/frf_set.hpp"
#include "ident/plan/coordinates.hpp"
#include "stability/exact_number.hpp"

namespace jointid::stability {

/// FRFs of one line between DOFs; 0 where no set has both.
template <class Scalar>
Pair<Scalar> frfs(const std::vector<frf::FrfSet>& sets, std::size_t line, const ident::Dofs& rows, const ident::Dofs& columns) {
  Pair<Scalar> out(at(rows.size()), at(columns.size()));
  for (const frf::FrfSet& set : sets) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const std::size_t r = frf::find_coordinate(set.header.response, rows[i]);
      for (std::size_t k = 0; r != frf::npos && k < columns.size(); ++k) {
        const std::size_t c = frf::find_coordinate(set.header.reference, columns[k]);
        if (c == frf::npos) continue;
        const int sign = rows[i].sign * set.header.response[r].sign * columns[k].sign * set.header.reference[c].sign;
        const Complex value = set.values[set.index(line, r, c)];
        out.re(at(i), at(k)) = Scalar(sign * value.real());
        out.im(at(i), at(k)) = Scalar(sign * value.imag());
      }
    }
  }
  return out;
}

}  // namespace jointid::stability
