#include "ident/judgement/h1_bias.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/statistics.hpp"
#include "ident/scene/variance_origin.hpp"
#include "ident/variance/noise_laws.hpp"

namespace jointid::ident {
namespace {

constexpr std::size_t bias_lines = 16, most_coherences = 1'000'000;

double lack_of_coherence(frf::FrfSource& source) {
  const frf::FrfHeader& header = source.header();
  std::vector<std::size_t> rows(header.response.size()), columns(header.reference.size());
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = i;
  for (std::size_t i = 0; i < columns.size(); ++i) columns[i] = i;
  const std::vector<std::size_t> lines = spread_lines(header.lines(), bias_lines);
  const frf::Block block{lines, rows, columns};
  if (block.size() == 0 || block.size() > most_coherences) return 0.0;
  std::vector<double> coherences(block.size());
  source.read_coherence(block, coherences);
  std::erase_if(coherences, [](double each) { return !(each > 0.0 && each <= 1.0); });
  return coherences.empty() ? 0.0 : 1.0 - median(coherences);
}

bool tells_coherences(const Scene& scene, const frf::FrfHeader& header) {
  try {
    return header.averages >= 2.0 && variance_origin(scene, header) == VarianceOrigin::coherence;
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace

double h1_bias(const Plan& plan) {
  if (!plan.regenerated.empty() || !plan.scene.couple_first.pairs.empty()) return 0.0;
  double largest = 0.0;
  for (frf::FrfSystem* const system : {plan.substructures.get(), plan.assembly.get()}) {
    for (std::size_t s = 0; s < system->source_count(); ++s) {
      if (tells_coherences(plan.scene, system->source(s).header()))
        largest = std::max(largest, lack_of_coherence(system->source(s)));
    }
  }
  return largest;
}

}  // namespace jointid::ident
