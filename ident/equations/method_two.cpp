
#include "base/eigen.hpp"
#include "dense/lu.hpp"
#include "ident/equations/equation_builder.hpp"
#include "minimise/linear/eigen_view.hpp"

namespace jointid::ident {
namespace {

class MethodTwo final : public EquationBuilder {
 public:
  MethodTwo(const Coordinates& at, const EquationSet& use, frf::FrfSystem& substructures, frf::FrfSystem& assembly)
      : all_(joined(at.responses, at.joint)),
        columns_(joined(only_if(use.jn, at.references), only_if(use.jj, at.joint))),
        joint_(at.joint.size()) {
    substructures_ = std::make_unique<Rectangle>(substructures, std::vector<Band>{{all_, all_}}, all_);
    assembly_ = std::make_unique<Rectangle>(assembly, std::vector<Band>{{all_, columns_}}, columns_);
    product_.a_is_unit = true;
    product_.wanted[1][0] = use.jn;
    product_.wanted[1][1] = use.jj;
    product_.row_class.assign(joint_, 1);
    product_.column_class.assign(use.jn ? at.references.size() : 0, 0);
    product_.column_class.resize(columns_.size(), 1);
  }

  bool line(std::size_t i, minimise::LineProduct& out) override {
    const auto h = map(substructures_->line(i));
    if (!h.allFinite()) return false;
    // Rows b of H_sub⁻¹, from a system with unit diagonal so that translations and rotations weigh alike.
    const Eigen::VectorXd scale = h.diagonal().cwiseAbs().cwiseSqrt().cwiseInverse();
    if (!scale.allFinite()) return false;
    Eigen::MatrixXcd unit = Eigen::MatrixXcd::Zero(h.rows(), at(joint_));
    for (std::size_t k = 0; k < joint_; ++k) unit(h.rows() - at(joint_ - k), at(k)) = 1.0;
    const Eigen::MatrixXcd solution = dense::solve((scale.asDiagonal() * h * scale.asDiagonal()).transpose(), unit);
    const RowMatrixXc z_b = scale.tail(at(joint_)).asDiagonal() * solution.transpose() * scale.asDiagonal();
    if (!z_b.allFinite()) return false;

    const minimise::View asm_view = assembly_->line(i);
    const auto h_asm = map(asm_view);
    const Eigen::Index n = h.rows() - at(joint_);
    c1_ = -z_b.leftCols(n) * h_asm.topRows(n);
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      if (product_.column_class[k] != 1) continue;
      const std::size_t joint = k - (columns_.size() - joint_);
      c1_(at(joint), at(k)) += 1.0;
    }
    c2_ = z_b.rightCols(at(joint_)) * h_asm.bottomRows(at(joint_));
    product_.frequency_hz = out.frequency_hz;
    product_.b = asm_view.block(static_cast<std::size_t>(n), 0, joint_, columns_.size());
    product_.c1 = {c1_.data(), joint_, columns_.size(), columns_.size()};
    product_.c2 = {c2_.data(), joint_, columns_.size(), columns_.size()};
    product_.wants_error_scale = out.wants_error_scale;
    if (out.wants_error_scale) measure_errors(h, z_b, h_asm);
    out = product_;
    return true;
  }

  Dofs columns() const override { return columns_; }

 private:
  /// An error δH of the inverted matrix moves C₁ − C₂ by Z_b δH·(Z H_asm). Rows n of Z H_asm are those of the unit matrix, rows b
  /// differ from them by the joint's forces, −(C₁ − C₂). To this comes Z_b times the errors of H_asm.
  template <class Sub, class Asm>
  void measure_errors(const Sub& h, const RowMatrixXc& z_b, const Asm& h_asm) {
    const Eigen::MatrixXd z = z_b.cwiseAbs(), amplified = z * h.cwiseAbs();
    RowMatrixXd error = amplified.rightCols(at(joint_)) * (c1_ - c2_).cwiseAbs() + z * h_asm.cwiseAbs();
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      error.col(at(k)) += amplified.col(at(frf::find_coordinate(all_, columns_[k])));
    }
    c_error_.assign(error.data(), error.data() + error.size());
    product_.c_error = c_error_;
  }

  Dofs all_, columns_;
  std::size_t joint_;
  std::vector<double> c_error_;
  RowMatrixXc c1_, c2_;
  minimise::LineProduct product_;
};

}  // namespace

std::unique_ptr<EquationBuilder> make_method_two(const Coordinates& coordinates, const EquationSet& equations,
                                                 frf::FrfSystem& substructures, frf::FrfSystem& assembly) {
  return std::make_unique<MethodTwo>(coordinates, equations, substructures, assembly);
}

}  // namespace jointid::ident
