#include "friction/path/loops.hpp"

#include <algorithm>
#include <cmath>

namespace jointid::friction {
namespace {

/// ∫F du over samples [first, last].
double branch_work(const Record& record, std::size_t first, std::size_t last) {
  double sum = 0.0;
  for (std::size_t i = first + 1; i <= last; ++i) {
    sum += 0.5 * (record.force[i] + record.force[i - 1]) * (record.displacement[i] - record.displacement[i - 1]);
  }
  return sum;
}

/// Appends samples [first, last].
void append(Record& to, const Record& from, std::size_t first, std::size_t last) {
  const auto copy = [&](std::vector<double>& out, const std::vector<double>& in) {
    out.insert(out.end(), in.begin() + static_cast<std::ptrdiff_t>(first), in.begin() + static_cast<std::ptrdiff_t>(last) + 1);
  };
  copy(to.displacement, from.displacement);
  copy(to.force, from.force);
}

/// The cycle between three reversals. The one at the upper end stands once when it begins and ends a cycle.
Loop cycle(const Record& record, std::size_t first, std::size_t middle, std::size_t last) {
  Loop loop;
  const bool falls_first = record.displacement[middle] < record.displacement[first];
  if (falls_first) {
    append(loop.record, record, middle, last);
    append(loop.record, record, first + 1, middle);
    loop.turn = last - middle;
  } else {
    append(loop.record, record, first, last);
    loop.turn = middle - first;
  }
  return loop;
}

}  // namespace

double Loop::amplitude() const {
  const auto& u = record.displacement;
  return 0.5 * (u[turn] - 0.5 * (u.front() + u.back()));
}

double Loop::energy() const {
  const auto& [u, f] = record;
  return work(record) + 0.5 * (f.front() + f.back()) * (u.front() - u.back());
}

std::vector<std::size_t> reversals(std::span<const double> displacement, double least_travel) {
  std::vector<std::size_t> found;
  std::size_t lowest = 0, highest = 0;
  int direction = 0;  // of the motion since the last reversal; 0 before the first travel is seen
  for (std::size_t i = 0; i < displacement.size(); ++i) {
    if (displacement[i] < displacement[lowest]) lowest = i;
    if (displacement[i] > displacement[highest]) highest = i;
    const bool up = displacement[i] - displacement[lowest] >= least_travel;
    const bool down = displacement[highest] - displacement[i] >= least_travel;
    if (direction <= 0 && up) {
      if (direction < 0) found.push_back(lowest);
      direction = 1;
      highest = i;
    } else if (direction >= 0 && down) {
      if (direction > 0) found.push_back(highest);
      direction = -1;
      lowest = i;
    }
  }
  return found;
}

std::vector<Loop> loops(const Record& record, double least_travel) {
  const std::vector<std::size_t> turns = reversals(record.displacement, least_travel);
  std::vector<Loop> out;
  for (std::size_t i = 0; i + 2 < turns.size(); i += 2) out.push_back(cycle(record, turns[i], turns[i + 1], turns[i + 2]));
  return out;
}

LoopCentre centre(const Loop& loop) {
  const auto& u = loop.record.displacement;
  const std::size_t last = u.size() - 1;
  const double rising = branch_work(loop.record, 0, loop.turn) / (u[loop.turn] - u.front());
  const double falling = branch_work(loop.record, loop.turn, last) / (u.back() - u[loop.turn]);
  return {u[loop.turn] - loop.amplitude(), 0.5 * (rising + falling)};
}

Loop centred(Loop loop) {
  const LoopCentre middle = centre(loop);
  for (double& u : loop.record.displacement) u -= middle.displacement;
  for (double& force : loop.record.force) force -= middle.force;
  return loop;
}

Record masing_curve(const Loop& loop) {
  const auto& [u, f] = loop.record;
  Record out;
  for (std::size_t i = 0; i < u.size(); ++i) {
    const bool rising = i <= loop.turn;
    const std::size_t start = rising ? 0 : loop.turn;
    const double direction = rising ? 1.0 : -1.0;
    out.displacement.push_back(0.5 * direction * (u[i] - u[start]));
    out.force.push_back(0.5 * direction * (f[i] - f[start]));
  }
  return out;
}

}  // namespace jointid::friction
