#include "ident/equations/equation_builder.hpp"

namespace jointid::ident {

void EquationBuilder::read(std::span<const std::size_t> substructure_lines,
                           std::span<const std::size_t> assembly_lines) {
  substructures_->read(substructure_lines);
  assembly_->read(assembly_lines);
}

std::size_t EquationBuilder::entries_per_line() const {
  return substructures_->entries_per_line() + assembly_->entries_per_line();
}

}  // namespace jointid::ident
