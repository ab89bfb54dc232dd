#include "ident/equation_builder.hpp"

namespace jointid::ident {

void EquationBuilder::read(std::span<const std::size_t> substructure_lines,
                           std::span<const std::size_t> assembly_lines) {
  substructures_->read(substructure_lines);
  assembly_->read(assembly_lines);
}

std::size_t EquationBuilder::entries_per_line() const {
  return substructures_->entries_per_line() + assembly_->entries_per_line();
}

Dofs joined(Dofs first, const Dofs& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

EquationSet::EquationSet(const std::vector<Equation>& equations) {
  for (const Equation equation : equations) {
    nn = nn || equation == Equation::nn;
    nj = nj || equation == Equation::nj;
    jj = jj || equation == Equation::jj;
    jn = jn || equation == Equation::jn;
  }
}

}  // namespace jointid::ident
