#include "ident/likelihood/variance_sources.hpp"

#include "ident/likelihood/likelihood_plan.hpp"

namespace jointid::ident {

std::vector<VarianceSource> variance_sources(const Plan& plan) {
  std::vector<VarianceSource> sources;
  if (!plan.likelihood) return sources;
  for (const FileVariances& file : plan.likelihood->observations->origins()) {
    sources.push_back({file.file, phrase(file.origin), note(file)});
  }
  return sources;
}

}  // namespace jointid::ident
