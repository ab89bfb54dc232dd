#include "friction/law/sliders.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>

#include "base/error.hpp"
#include "friction/law/bilinear.hpp"
#include "friction/law/spring.hpp"
#include "friction/path/parallel.hpp"

namespace jointid::friction {
namespace {

struct Gap {
  double from, to, error;
  bool operator<(const Gap& other) const { return error < other.error; }
};

Gap gap(const Element& element, double from, double to) {
  const auto force = [&](double u) { return u > 0.0 ? element.response(u).force : 0.0; };
  return {from, to, force(0.5 * (from + to)) - 0.5 * (force(from) + force(to))};
}

}  // namespace

Sliders sliders(const Element& element, std::span<const double> knots) {
  if (knots.empty() || knots.front() <= 0.0 || std::ranges::adjacent_find(knots, std::greater_equal()) != knots.end()) {
    refuse("sliders: knots must be increasing and > 0");
  }
  Sliders result;
  double last = 0.0, last_force = 0.0, slope = 0.0;
  for (const double knot : knots) {
    const double force = element.response(knot).force, next = (force - last_force) / (knot - last);
    if (last > 0.0 && slope > next) {
      result.slip.push_back(last);
      result.stiffness.push_back(slope - next);
    }
    last = knot;
    last_force = force;
    slope = next;
  }
  result.rest = std::min(element.response(last).tangent, slope);
  if (slope > result.rest) {
    result.slip.push_back(last);
    result.stiffness.push_back(slope - result.rest);
  }
  return result;
}

std::vector<double> slip_knots(const Element& element, std::size_t count, double largest) {
  const double end = std::min(largest, element.displacement(element.limit()));
  std::vector<double> kinks = element.kinks();
  std::erase_if(kinks, [&](double kink) { return kink >= end; });
  kinks.push_back(end);
  std::priority_queue<Gap> gaps;
  std::vector<double> knots;
  for (double from = 0.0; const double kink : kinks) {
    gaps.push(gap(element, from, kink));
    knots.push_back(from = kink);
  }
  while (knots.size() < count) {
    const Gap widest = gaps.top();
    const double middle = 0.5 * (widest.from + widest.to);
    gaps.pop();
    gaps.push(gap(element, widest.from, middle));
    gaps.push(gap(element, middle, widest.to));
    knots.push_back(middle);
  }
  std::ranges::sort(knots);
  return knots;
}

Sliders even_sliders(const Element& element, std::size_t count) {
  const double stiffness = element.response(0.0).tangent, each = stiffness / static_cast<double>(count);
  Sliders result;
  for (std::size_t i = 0; i < count; ++i) {
    const double tangent = stiffness * (1.0 - (static_cast<double>(i) + 0.5) / static_cast<double>(count));
    double low = 0.0, high = 1.0;
    while (element.response(high).tangent > tangent && high < 1e12) high *= 2.0;
    if (element.response(high).tangent > tangent) {
      result.rest += each;
      continue;
    }
    for (int step = 0; step < 2000; ++step) {
      const double middle = low > 0.0 ? std::sqrt(low) * std::sqrt(high) : 1e-3 * high;  // decades first
      if (!(middle > low && middle < high) || high < 1e-300) break;
      (element.response(middle).tangent > tangent ? low : high) = middle;
    }
    result.slip.push_back(high);
    result.stiffness.push_back(each);
  }
  return result;
}

std::unique_ptr<Element> bilinear_assembly(const Sliders& sliders) {
  std::vector<std::shared_ptr<const Element>> parts;
  for (std::size_t i = 0; i < sliders.slip.size(); ++i) {
    parts.push_back(std::make_shared<Bilinear>(std::array{sliders.slip[i], sliders.stiffness[i]}));
  }
  if (sliders.rest > 0.0) parts.push_back(std::make_shared<Spring>(std::array{sliders.rest}));
  return std::make_unique<Parallel>(std::move(parts));
}

}  // namespace jointid::friction
