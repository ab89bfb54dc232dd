#include "problems/structure/spring_coupling.hpp"

#include "base/complex.hpp"

namespace jointid::problems {
namespace {

/// A spring by the places of its ends in a set; `second` is npos where it goes to ground.
struct PlacedSpring {
  std::size_t first, second;
  double first_sign, second_sign;
  Complex stiffness;

  /// bᵀx of a vector whose element i is x(i).
  template <class Vector>
  Complex across(const Vector& x) const {
    return first_sign * x(first) - (second == frf::npos ? Complex() : second_sign * x(second));
  }
};

PlacedSpring placed(const frf::FrfHeader& header, const ComplexSpring& spring) {
  const auto place = [&](const frf::Dof& dof) { return frf::find_coordinate(header.response, dof); };
  PlacedSpring out{place(spring.ends.first), frf::npos, 1.0, 1.0, spring.stiffness};
  out.first_sign = spring.ends.first.sign * header.response[out.first].sign;
  if (!spring.ends.second) return out;
  out.second = place(*spring.ends.second);
  out.second_sign = spring.ends.second->sign * header.response[out.second].sign;
  return out;
}

}  // namespace

frf::FrfSet side_by_side(const std::vector<frf::FrfSet>& parts) {
  frf::FrfSet out;
  out.header = parts.front().header;
  for (std::size_t p = 1; p < parts.size(); ++p) {
    const frf::FrfHeader& header = parts[p].header;
    out.header.response.insert(out.header.response.end(), header.response.begin(), header.response.end());
    out.header.nodes.insert(out.header.nodes.end(), header.nodes.begin(), header.nodes.end());
  }
  out.header.reference = out.header.response;
  out.values.assign(out.header.lines() * out.header.entries(), 0.0);
  std::size_t first = 0;
  for (const frf::FrfSet& part : parts) {
    const std::size_t n = part.header.response.size();
    for (std::size_t line = 0; line < out.header.lines(); ++line) {
      for (std::size_t r = 0; r < n; ++r) {
        for (std::size_t c = 0; c < n; ++c) out.values[out.index(line, first + r, first + c)] = part.values[part.index(line, r, c)];
      }
    }
    first += n;
  }
  return out;
}

frf::FrfSet with_springs(frf::FrfSet set, const std::vector<ComplexSpring>& springs) {
  const std::size_t n = set.header.response.size();
  std::vector<Complex> column(n), row(n);
  for (const ComplexSpring& each : springs) {
    const PlacedSpring spring = placed(set.header, each);
    for (std::size_t line = 0; line < set.header.lines(); ++line) {
      Complex* h = set.values.data() + set.index(line, 0, 0);
      for (std::size_t i = 0; i < n; ++i) {
        column[i] = spring.across([&](std::size_t j) { return h[i * n + j]; });
        row[i] = spring.across([&](std::size_t j) { return h[j * n + i]; });
      }
      const Complex factor = 1.0 / (1.0 / spring.stiffness + spring.across([&](std::size_t j) { return column[j]; }));
      for (std::size_t i = 0; i < n; ++i) {
        const Complex from = factor * column[i];
        for (std::size_t j = 0; j < n; ++j) h[i * n + j] -= from * row[j];
      }
    }
  }
  return set;
}

}  // namespace jointid::problems
