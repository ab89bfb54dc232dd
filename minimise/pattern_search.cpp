#include <limits>

#include "minimise/least_squares.hpp"

namespace jointid::minimise {
namespace {

class Walk {
 public:
  Walk(const Objective& f, const PatternOptions& options) : f_(f), options_(options) {}

  Minimum run(std::vector<double> best) {
    double least = value(best), step = options_.step;
    Minimum out;
    while (step >= options_.tolerance && used_ < options_.most_evaluations) {
      ++out.iterations;
      std::vector<double> point = best;
      double at = explore(point, least, step);
      if (!(at < least)) {
        step *= 0.5;
        continue;
      }
      while (at < least && used_ < options_.most_evaluations) at = follow(best, least, point, at, step);
    }
    out.converged = step < options_.tolerance;
    out.q = std::move(best);
    return out;
  }

 private:
  double value(const std::vector<double>& point) {
    ++used_;
    return f_(point);
  }

  /// Moves `point` along each axis where that helps; its value.
  double explore(std::vector<double>& point, double at, double step) {
    for (double& coordinate : point) {
      const double middle = coordinate;
      for (const double trial : {middle + step, middle - step}) {
        coordinate = trial;
        const double there = value(point);
        if (there < at) {
          at = there;
          break;
        }
        coordinate = middle;
      }
    }
    return at;
  }

  /// `point` becomes the best one, and the next is explored as far beyond it again. The next one's value.
  double follow(std::vector<double>& best, double& least, std::vector<double>& point, double at, double step) {
    std::vector<double> next = point;
    for (std::size_t i = 0; i < next.size(); ++i) next[i] += point[i] - best[i];
    best = point;
    least = at;
    const double there = explore(next, value(next), step);
    point = std::move(next);
    return there;
  }

  const Objective& f_;
  const PatternOptions& options_;
  std::size_t used_ = 0;
};

}  // namespace

Minimum pattern_search(const Objective& f, std::span<const double> start, const PatternOptions& options) {
  return Walk(f, options).run({start.begin(), start.end()});
}

}  // namespace jointid::minimise
