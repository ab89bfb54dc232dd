#include "impedance/line/line_blocks.hpp"

#include <algorithm>

#include "base/complex.hpp"

namespace jointid::impedance {
namespace {

/// Errors of elements whose number in the line's data is given.
class Directions {
 public:
  Directions(const ident::LineData& data, std::vector<Complex> weight, std::vector<std::size_t> elements)
      : data_(data), weight_(std::move(weight)), elements_(std::move(elements)) {}

  ErrorColumns all() const {
    ErrorColumns out;
    for (std::size_t e = 0; e < elements_.size(); ++e) {
      if (is_in_group(elements_[e])) continue;
      const auto frf = static_cast<Eigen::Index>(e);
      out.push_back({{frf, deviation(weight_[e].real())}});
      out.push_back({{frf, Complex(0.0, deviation(weight_[e].imag()))}});
    }
    if (!data_.correlation) return out;
    for (const minimise::Correlation::Group& group : data_.correlation->groups()) add_group(group, out);
    return out;
  }

 private:
  static double deviation(double weight) { return weight > 0.0 ? 1.0 / weight : 0.0; }

  bool is_in_group(std::size_t element) const {
    return data_.correlation && data_.correlation->place(element).group != minimise::Correlation::none;
  }

  /// Real errors of a group, whose factor is over complex numbers, or over real and imaginary parts.
  void add_group(const minimise::Correlation::Group& group, ErrorColumns& out) const {
    const auto size = static_cast<Eigen::Index>(group.elements.size());
    Eigen::MatrixXcd errors(size, 2 * size);
    if (group.parts.size() > 0) {
      errors.real() = group.parts.topRows(size);
      errors.imag() = group.parts.bottomRows(size);
    } else {
      errors << group.factor, Complex(0.0, 1.0) * group.factor;
    }
    for (Eigen::Index k = 0; k < 2 * size; ++k) {
      out.emplace_back();
      for (Eigen::Index i = 0; i < size; ++i) {
        const auto found = std::ranges::find(elements_, group.elements[static_cast<std::size_t>(i)]);
        if (found == elements_.end() || errors(i, k) == 0.0) continue;
        const Complex w = weight_[static_cast<std::size_t>(found - elements_.begin())];
        out.back().emplace_back(found - elements_.begin(),
                                Complex(errors(i, k).real() * deviation(w.real()), errors(i, k).imag() * deviation(w.imag())));
      }
    }
  }

  const ident::LineData& data_;
  std::vector<Complex> weight_;
  std::vector<std::size_t> elements_;
};

}  // namespace

LineBlocks blocks_of(const ident::LineLayout& layout, const ident::LineData& data) {
  LineBlocks out;
  out.others = layout.others;
  out.joint = layout.joint;
  out.omega = data.omega;
  const auto size = at(layout.others + layout.joint), n = at(layout.others);
  out.substructures = out.assembly = Eigen::MatrixXcd::Zero(size, size);
  out.known_substructures = Eigen::MatrixXd::Ones(size, size);  // what the layout lacks of X and Y is zero by construction
  out.known_assembly = Eigen::MatrixXd::Zero(size, size);
  out.known_substructures.topLeftCorner(n, n).setZero();
  std::vector<Complex> weights;
  std::vector<std::size_t> elements;
  std::size_t element = 0;
  const auto add = [&](const std::vector<ident::Element>& places, const ident::Channel& channel, Eigen::Index row,
                       Eigen::Index column, bool of_assembly) {
    Eigen::MatrixXcd& values = of_assembly ? out.assembly : out.substructures;
    Eigen::MatrixXd& known = of_assembly ? out.known_assembly : out.known_substructures;
    for (std::size_t i = 0; i < places.size(); ++i, ++element) {
      const Eigen::Index r = row + at(places[i].row), c = column + at(places[i].column);
      const bool is_measured = channel.weight[i] != Complex(0.0);
      known(r, c) = known(c, r) = is_measured ? 1.0 : 0.0;
      values(r, c) = values(c, r) = is_measured ? channel.value[i] : Complex(0.0);
      if (!is_measured) continue;
      out.frfs.push_back({r, c, of_assembly});
      weights.push_back(channel.weight[i]);
      elements.push_back(element);
    }
  };
  add(layout.sub_jn, data.sub_jn, n, 0, false);
  add(layout.sub_jj, data.sub_jj, n, n, false);
  add(layout.asm_jn, data.asm_jn, n, 0, true);
  add(layout.asm_jj, data.asm_jj, n, n, true);
  add(layout.drop_nn, data.drop_nn, 0, 0, false);
  out.known_assembly.topLeftCorner(n, n) = out.known_substructures.topLeftCorner(n, n);
  out.errors = Directions(data, std::move(weights), std::move(elements)).all();
  return out;
}

bool is_known(const Eigen::MatrixXd& known, const std::vector<Eigen::Index>& rows, const std::vector<Eigen::Index>& columns) {
  return std::ranges::all_of(
      rows, [&](Eigen::Index r) { return std::ranges::all_of(columns, [&](Eigen::Index c) { return known(r, c) > 0.0; }); });
}

}  // namespace jointid::impedance
