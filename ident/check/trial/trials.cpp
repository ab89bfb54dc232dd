#include "ident/check/trial/trials.hpp"

#include <algorithm>
#include <cmath>

#include "ident/check/trial/channel_trials.hpp"
#include "ident/check/trial/file_trials.hpp"
#include "ident/check/trial/gain_trials.hpp"

namespace jointid::ident {
namespace {

/// Whether some test leaves more than signs and labels may be to blame for; of files with covariances more than these explain.
bool is_large(const std::vector<CheckedFile>& files, const std::vector<SpanSetup>& setups, const Screening& screening,
              const Misfit& misfit) {
  constexpr double beyond = 1.5;  // of the noise
  const auto noise = [&](std::size_t f) { return files[f].errors ? screening.noise[f] : 0.0; };
  for (std::size_t s = 0; s < setups.size(); ++s) {
    const double known = setups[s].weighed ? 0.0 : std::hypot(noise(setups[s].part), noise(setups[s].assembly));
    if (misfit.span[s] > std::max(large_misfit, beyond * known)) return true;
  }
  for (std::size_t f = 0; f < files.size(); ++f) {
    if (misfit.reciprocity[f] > std::max(large_misfit, beyond * noise(f))) return true;
  }
  return false;
}

}  // namespace

std::vector<MistakeTrial> trials_of(const std::vector<CheckedFile>& files, const std::vector<SpanSetup>& setups,
                                    const Screening& screening, const Misfit& misfit) {
  std::vector<MistakeTrial> out;
  const auto add = [&](std::vector<MistakeTrial> more) {
    out.insert(out.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  };
  const bool active = std::ranges::any_of(misfit.active, [](double a) { return a > 0.0; });
  if (active || is_large(files, setups, screening, misfit)) {
    add(channel_trials(files, setups, screening));
    add(exchange_trials(files));
  }
  add(gain_trials(files, setups, screening));
  add(file_trials(files, setups, screening, misfit));
  return out;
}

}  // namespace jointid::ident
