#include "ident/likelihood/findings/variance_sources.hpp"

#include "ident/likelihood/data/likelihood_plan.hpp"

namespace jointid::ident {

std::vector<VarianceSource> variance_sources(const Plan& plan) {
  std::vector<VarianceSource> sources;
  const LikelihoodPlan* own = likelihood_plan(plan);
  if (own == nullptr) return sources;
  for (const FileVariances& file : own->observations->origins()) {
    sources.push_back({file.file, phrase(file.origin), note(file)});
  }
  return sources;
}

}  // namespace jointid::ident
