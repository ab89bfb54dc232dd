#include "ident/team/line_shares.hpp"

#include <algorithm>
#include <cassert>

namespace jointid::ident {
namespace {

/// What stands before the numbers of a process.
constexpr double goes_on = 0.0, failed = 1.0;

}  // namespace

LineShares::Range LineShares::own(std::size_t count) const {
  if (size() == 1) return {0, count};
  const std::size_t rank = team_->rank();
  return {count * rank / size(), count * (rank + 1) / size()};
}

std::vector<std::vector<double>> LineShares::exchange(double state, const std::vector<double>& own) const {
  std::vector<double> numbers = {state};
  numbers.insert(numbers.end(), own.begin(), own.end());
  return team_->gathered(numbers);
}

std::vector<std::vector<double>> LineShares::gathered(const std::vector<double>& own) const {
  if (size() == 1) return {own};
  auto all = exchange(goes_on, own);
  if (std::ranges::any_of(all, [](const std::vector<double>& each) { return each.front() == failed; })) throw ToldElsewhere();
  for (std::vector<double>& each : all) each.erase(each.begin());
  return all;
}

void LineShares::sum(std::span<double> numbers) const {
  if (size() == 1) return;
  const auto all = gathered({numbers.begin(), numbers.end()});
  std::ranges::fill(numbers, 0.0);
  for (const std::vector<double>& each : all) {
    assert(each.size() == numbers.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] += each[i];
  }
}

void LineShares::complete(std::span<double> numbers, std::size_t lines) const {
  if (size() == 1 || lines == 0) return;
  const std::size_t width = numbers.size() / lines;
  const Range here = own(lines);
  const auto known = numbers.subspan(here.first * width, here.size() * width);
  auto to = numbers.begin();
  for (const std::vector<double>& each : gathered({known.begin(), known.end()})) to = std::ranges::copy(each, to).out;
}

bool LineShares::any(bool here) const {
  double count = here ? 1.0 : 0.0;
  sum({&count, 1});
  return count > 0.0;
}

/// Two that fail at once are told once: by the first.
void LineShares::tell_failure() const {
  const auto all = exchange(failed, {});
  const auto first = std::ranges::find_if(all, [](const std::vector<double>& each) { return each.front() == failed; });
  if (static_cast<std::size_t>(first - all.begin()) != team_->rank()) throw ToldElsewhere();
}

}  // namespace jointid::ident
