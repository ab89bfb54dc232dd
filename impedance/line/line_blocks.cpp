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

  Eigen::MatrixXcd all() const {
    const auto count = static_cast<Eigen::Index>(elements_.size());
    Eigen::MatrixXcd out = Eigen::MatrixXcd::Zero(count, 2 * count);
    for (Eigen::Index e = 0; e < count; ++e) {
      const Complex w = weight_[static_cast<std::size_t>(e)];
      if (group_of(e) != minimise::Correlation::none) continue;
      out(e, 2 * e) = deviation(w.real());
      out(e, 2 * e + 1) = Complex(0.0, deviation(w.imag()));
    }
    if (data_.correlation) {
      for (std::size_t g = 0; g < data_.correlation->groups().size(); ++g) add_group(g, out);
    }
    return out;
  }

 private:
  static double deviation(double weight) { return weight > 0.0 ? 1.0 / weight : 0.0; }

  std::size_t group_of(Eigen::Index e) const {
    if (!data_.correlation) return minimise::Correlation::none;
    return data_.correlation->place(elements_[static_cast<std::size_t>(e)]).group;
  }

  /// A group takes the columns of its members.
  void add_group(std::size_t g, Eigen::MatrixXcd& out) const {
    const minimise::Correlation::Group& group = data_.correlation->groups()[g];
    std::vector<Eigen::Index> members;  // in `elements`, −1: not measured
    for (const std::size_t element : group.elements) {
      const auto found = std::ranges::find(elements_, element);
      members.push_back(found == elements_.end() ? -1 : found - elements_.begin());
    }
    const auto size = static_cast<Eigen::Index>(members.size());
    Eigen::MatrixXcd errors(size, 2 * size);
    if (group.parts.size() > 0) {
      errors.real() = group.parts.topRows(size);
      errors.imag() = group.parts.bottomRows(size);
    } else {
      errors << group.factor, Complex(0.0, 1.0) * group.factor;
    }
    for (Eigen::Index k = 0; k < 2 * size; ++k) {
      const Eigen::Index owner = members[static_cast<std::size_t>(k / 2)];
      if (owner < 0) continue;
      for (Eigen::Index i = 0; i < size; ++i) {
        const Eigen::Index e = members[static_cast<std::size_t>(i)];
        if (e < 0) continue;
        const Complex w = weight_[static_cast<std::size_t>(e)];
        out(e, 2 * owner + k % 2) = {errors(i, k).real() * deviation(w.real()), errors(i, k).imag() * deviation(w.imag())};
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
  const auto size = LineBlocks::at(layout.others + layout.joint), n = LineBlocks::at(layout.others);
  out.substructures = out.assembly = Eigen::MatrixXcd::Zero(size, size);
  out.known_substructures = Eigen::MatrixXd::Ones(size, size);  // what the layout lacks of X and Y is zero by construction
  out.known_assembly = Eigen::MatrixXd::Zero(size, size);
  out.known_substructures.topLeftCorner(n, n).setZero();
  std::vector<Complex> weights;
  std::vector<std::size_t> elements;
  std::size_t element = 0;
  const auto add = [&](const std::vector<ident::Element>& places, const ident::Channel& channel, Eigen::Index row, Eigen::Index column,
                       bool of_assembly) {
    Eigen::MatrixXcd& values = of_assembly ? out.assembly : out.substructures;
    Eigen::MatrixXd& known = of_assembly ? out.known_assembly : out.known_substructures;
    for (std::size_t i = 0; i < places.size(); ++i, ++element) {
      const Eigen::Index r = row + LineBlocks::at(places[i].row), c = column + LineBlocks::at(places[i].column);
      const bool is_measured = channel.weight[i] != Complex(0.0);
      known(r, c) = known(c, r) = is_measured ? 1.0 : 0.0;
      values(r, c) = values(c, r) = is_measured ? channel.value[i] : Complex(0.0);
      if (!is_measured) continue;
      out.frfs.push_back({r, c, of_assembly});
      weights.push_back(channel.weight[i]);
      elements.push_back(element);
    }
  };
  add(layout.x, data.x, n, 0, false);
  add(layout.y, data.y, n, n, false);
  add(layout.a, data.a, n, 0, true);
  add(layout.b, data.b, n, n, true);
  add(layout.d, data.d, 0, 0, false);
  out.known_assembly.topLeftCorner(n, n) = out.known_substructures.topLeftCorner(n, n);
  out.directions = Directions(data, std::move(weights), std::move(elements)).all();
  return out;
}

bool is_known(const Eigen::MatrixXd& known, const std::vector<Eigen::Index>& rows, const std::vector<Eigen::Index>& columns) {
  return std::ranges::all_of(rows, [&](Eigen::Index r) {
    return std::ranges::all_of(columns, [&](Eigen::Index c) { return known(r, c) > 0.0; });
  });
}

}  // namespace jointid::impedance
