
#include "base/eigen.hpp"
#include "dense/minimum_norm.hpp"
#include "ident/equations/equation_builder.hpp"
#include "minimise/linear/eigen_view.hpp"

namespace jointid::ident {
namespace {

class Direct final : public EquationBuilder {
 public:
  Direct(const Coordinates& at, frf::FrfSystem& substructures, frf::FrfSystem& assembly)
      : columns_(at.references),
        rows_(at.responses.size()),
        joint_(at.joint.size()) {
    const Dofs all_columns = joined(columns_, at.joint);
    substructures_ = std::make_unique<Rectangle>(
        substructures, std::vector<Band>{{joined(at.responses, at.joint), all_columns}}, all_columns);
    assembly_ = std::make_unique<Rectangle>(assembly, std::vector<Band>{{at.responses, columns_}}, columns_);
    product_.wanted[0][0] = true;
    product_.row_class.assign(rows_, 0);
    product_.column_class.assign(columns_.size(), 0);
  }

  bool line(std::size_t i, minimise::LineProduct& out) override {
    const std::size_t columns = columns_.size();
    const minimise::View sub = substructures_->line(i);
    const minimise::View h_aa = sub.block(0, 0, rows_, columns), h_ab = sub.block(0, columns, rows_, joint_);
    const minimise::View h_ba = sub.block(rows_, 0, joint_, columns), h_bb = sub.block(rows_, columns, joint_, joint_);
    const minimise::View h_nn = assembly_->line(i);
    if (!map(sub).allFinite() || !map(h_nn).allFinite()) return false;
    const dense::ComplexMinimumNorm decomposition(map(h_ba));
    if (decomposition.rank() < at(joint_)) return false;
    // Solved, not multiplied by an inverse: its error would be amplified by C₁ − C₂ once more.
    const Eigen::MatrixXcd carried = decomposition.solve(map(h_bb));
    h_nj_ = map(h_ab) - (map(h_aa) - map(h_nn)) * carried;
    product_.wants_error_scale = out.wants_error_scale;
    if (out.wants_error_scale)
      measure_errors(map(h_aa), map(h_ab), map(h_ba), map(h_bb), map(h_nn), decomposition.pseudo_inverse(), carried);
    product_.frequency_hz = out.frequency_hz;
    product_.a = {h_nj_.data(), rows_, joint_, joint_};
    product_.b = h_ba;
    product_.c1 = h_aa;
    product_.c2 = h_nn;
    out = product_;
    return true;
  }

  Dofs columns() const override { return columns_; }

 private:
  /// H_nj = H_ab − C X, C = H_aa − H_nn, H_ba X = H_bb: C moves by the errors of its terms, X by H_ba⁺(δH_ba X + δH_bb), where
  /// δH_ba is also what the solution of the system is off by, relative to its largest element.
  template <class Block>
  void measure_errors(const Block& h_aa, const Block& h_ab, const Block& h_ba, const Block& h_bb, const Block& h_nn,
                      const Eigen::MatrixXcd& inverse, const Eigen::MatrixXcd& x) {
    const Eigen::MatrixXd carried = x.cwiseAbs(), moved = ((h_aa - h_nn) * inverse).cwiseAbs();
    const Eigen::MatrixXd inverted = Eigen::MatrixXd::Constant(h_ba.rows(), h_ba.cols(), h_ba.cwiseAbs().maxCoeff());
    const RowMatrixXd error =
        h_ab.cwiseAbs() + (h_aa.cwiseAbs() + h_nn.cwiseAbs()) * carried + moved * (inverted * carried + h_bb.cwiseAbs());
    a_error_.assign(error.data(), error.data() + error.size());
    product_.a_error = a_error_;
  }

  Dofs columns_;
  std::size_t rows_, joint_;
  RowMatrixXc h_nj_;
  std::vector<double> a_error_;
  minimise::LineProduct product_;
};

}  // namespace

std::unique_ptr<EquationBuilder> make_direct(const Coordinates& coordinates, frf::FrfSystem& substructures,
                                             frf::FrfSystem& assembly) {
  return std::make_unique<Direct>(coordinates, substructures, assembly);
}

}  // namespace jointid::ident
