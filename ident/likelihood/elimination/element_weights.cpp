#include "ident/likelihood/elimination/element_weights.hpp"

#include "base/eigen.hpp"
#include "ident/likelihood/line/reduced_line.hpp"

namespace jointid::ident {

void ElementWeights::take(const LineLayout& layout, const LineData& data, const LineState& state) {
  const std::size_t v = layout.variables();
  all.resize(at(v + layout.asm_jn.size() + layout.asm_jj.size() + layout.drop_nn.size()));
  Eigen::Index i = 0;
  for (const Channel* channel : {&data.sub_jn, &data.sub_jj, &data.asm_jn, &data.asm_jj, &data.drop_nn}) {
    for (const Complex weight : channel->weight) all[i++] = weight.real();
  }
  own_squared = all.head(at(v));
  const double x_guess = guessed_weight(state.sub_jn), y_guess = guessed_weight(state.sub_jj);
  for (std::size_t k = 0; k < v; ++k) {
    if (own_squared[at(k)] == 0.0) own_squared[at(k)] = k < layout.sub_jn.size() ? x_guess : y_guess;
  }
  own_squared = own_squared.cwiseAbs2();
}

}  // namespace jointid::ident
