#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/control.hpp"
#include "ident/team/team.hpp"

namespace jointid::ident {

/// How the processes of a team share the lines of one solution. All do the same steps in the same order; what needs the FRFs of a
/// line is done by the process whose line it is, and what is left of it is exchanged: afterwards all know the same numbers, to
/// the last bit, and decide alike. Alone, nothing is exchanged. To be used by the thread that joined the team.
class LineShares {
 public:
  struct Range {
    std::size_t first = 0, last = 0;
    bool has(std::size_t i) const { return first <= i && i < last; }
    std::size_t size() const { return last - first; }
  };

  LineShares() = default;
  explicit LineShares(Team& team) : team_(&team) {}

  std::size_t size() const { return team_ ? team_->size() : 1; }

  /// Which of `count` lines are this process's: a run of them, in the order of the processes, of sizes that differ by one at
  /// most.
  Range own(std::size_t count) const;

  /// Numbers of every process, any number of them, in the order of the processes. Throws ToldElsewhere where one failed
  /// (together()).
  std::vector<std::vector<double>> gathered(const std::vector<double>& own) const;

  /// Adds up the numbers of all processes, in their order.
  void sum(std::span<double> numbers) const;

  /// Fills in what the other processes know: `numbers` holds the same count of numbers for each line, of which own(lines) are
  /// known.
  void complete(std::span<double> numbers, std::size_t lines) const;

  bool any(bool here) const;

  /// Work that all processes do. Where it throws in one of them that one throws on, and the others ToldElsewhere. Interrupted is
  /// not told to the others: mpirun asks all to end.
  template <class Work>
  auto together(Work&& work) const {
    if (size() == 1) return work();
    try {
      auto result = work();
      gathered({});
      return result;
    } catch (const ToldElsewhere&) {
      throw;
    } catch (const Interrupted&) {
      throw;
    } catch (...) {
      tell_failure();
      throw;
    }
  }

 private:
  std::vector<std::vector<double>> exchange(double state, const std::vector<double>& own) const;
  void tell_failure() const;

  Team* team_ = nullptr;
};

}  // namespace jointid::ident
