#include "ident/check/test/screening.hpp"

#include <algorithm>

#include "base/parallel.hpp"

namespace jointid::ident {

Screening screen(const std::vector<CheckedFile>& files, const std::vector<SpanSetup>& setups, std::size_t threads) {
  constexpr double unknown_noise = 1e9, usual_noise = 0.05;
  Screening out;
  out.span.resize(setups.size());
  for_each_index(setups.size(), threads, [&](std::size_t s) { out.span[s] = span_test(setups[s], files, SpanDetail::rows); });
  out.noise.assign(files.size(), unknown_noise);
  for (std::size_t s = 0; s < setups.size(); ++s) {
    if (out.span[s].lines == 0) continue;
    for (const std::size_t f : {setups[s].part, setups[s].assembly}) out.noise[f] = std::min(out.noise[f], out.span[s].level);
  }
  out.reciprocity.resize(files.size());
  out.phase.resize(files.size());
  for_each_index(files.size(), threads, [&](std::size_t f) {
    out.reciprocity[f] = reciprocity_test(files[f], true);
    out.phase[f] = phase_test(files[f], true);
    out.noise[f] = files[f].errors ? relative_error(files[f]) : out.noise[f] == unknown_noise ? usual_noise : out.noise[f];
    out.noise[f] = std::max(out.noise[f], 0.003);
  });
  return out;
}

std::size_t lines_for(const std::vector<SpanSetup>& setups, std::size_t most, double work) {
  double per_line = 1.0;
  for (const SpanSetup& setup : setups) {
    const std::size_t columns = setup.part_columns.size() + setup.outer_columns.size();
    const std::size_t per_column = setup.rows.size() * (setup.joint.size() + (setup.weighed ? 2 * setup.rows.size() : 0));
    per_line += static_cast<double>(columns * per_column);
  }
  return std::clamp<std::size_t>(static_cast<std::size_t>(work / per_line), 8, most);
}

}  // namespace jointid::ident
