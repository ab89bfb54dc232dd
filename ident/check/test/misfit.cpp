#include "ident/check/test/misfit.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"

namespace jointid::ident {
namespace {

constexpr double floor_of_levels = 0.004;
constexpr double floor_of_imaginary = 0.2;

double log_ratio(const std::vector<double>& before, const std::vector<double>& after, double floor) {
  double sum = 0.0;
  for (std::size_t i = 0; i < before.size(); ++i) sum += std::log(std::hypot(before[i], floor) / std::hypot(after[i], floor));
  return sum;
}

}  // namespace

double activity(const CheckedFile& file, double noise) {
  const PassivityTest test = passivity_test(file, noise);
  double sum = std::clamp((test.total - 5.0) / 5.0, 0.0, 3.0);
  for (const double excess : test.excess) sum += std::clamp((excess - 4.0) / 8.0, 0.0, 0.5);
  return sum;
}

Misfit misfit_of(const std::vector<CheckedFile>& files, const std::vector<SpanSetup>& setups, const std::vector<double>& noise,
                 std::size_t threads) {
  Misfit empty{.span = std::vector<double>(setups.size()),
               .reciprocity = std::vector<double>(files.size()),
               .imaginary = std::vector<double>(files.size()),
               .active = std::vector<double>(files.size())};
  return misfit_of(files, setups, noise, empty, {.files = std::vector<bool>(files.size(), true), .only_span = false}, threads);
}

Misfit misfit_of(const std::vector<CheckedFile>& files, const std::vector<SpanSetup>& setups, const std::vector<double>& noise,
                 const Misfit& before, const Touched& touched, std::size_t threads) {
  Misfit after = before;
  for_each_index(setups.size(), threads, [&](std::size_t s) {
    if (touched.setup(setups[s])) after.span[s] = span_test(setups[s], files, SpanDetail::level).level;
  });
  if (touched.only_span) return after;
  for_each_index(files.size(), threads, [&](std::size_t f) {
    if (!touched.files[f]) return;
    after.reciprocity[f] = reciprocity_test(files[f], false).level;
    after.imaginary[f] = 1.0 - phase_test(files[f], false).real_share;
    after.active[f] = activity(files[f], noise[f]);
  });
  return after;
}

double healing(const Misfit& before, const Misfit& after) {
  double sum =
      log_ratio(before.span, after.span, floor_of_levels) + log_ratio(before.reciprocity, after.reciprocity, floor_of_levels);
  sum += log_ratio(before.imaginary, after.imaginary, floor_of_imaginary);
  for (std::size_t f = 0; f < before.active.size(); ++f) sum += before.active[f] - after.active[f];
  return sum;
}

}  // namespace jointid::ident
