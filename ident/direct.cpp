#include <Eigen/QR>

#include "ident/eigen_view.hpp"
#include "ident/equation_builder.hpp"

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

  bool line(std::size_t i, LineProduct& out) override {
    const std::size_t columns = columns_.size();
    const View sub = substructures_->line(i);
    const View h_aa = sub.block(0, 0, rows_, columns), h_ab = sub.block(0, columns, rows_, joint_);
    const View h_ba = sub.block(rows_, 0, joint_, columns), h_bb = sub.block(rows_, columns, joint_, joint_);
    const View h_nn = assembly_->line(i);
    if (!map(sub).allFinite() || !map(h_nn).allFinite()) return false;
    const Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXcd> decomposition(map(h_ba));
    if (decomposition.rank() < static_cast<Eigen::Index>(joint_)) return false;
    const Eigen::MatrixXcd inverse = decomposition.pseudoInverse(), carried = inverse * map(h_bb);
    h_nj_ = map(h_ab) - (map(h_aa) - map(h_nn)) * carried;
    product_.wants_error_scale = out.wants_error_scale;
    if (out.wants_error_scale) {
      const Eigen::MatrixXd moved = ((map(h_aa) - map(h_nn)) * inverse).cwiseAbs();
      const RowMatrixXd error = map(h_ab).cwiseAbs() + (map(h_aa).cwiseAbs() + map(h_nn).cwiseAbs()) * carried.cwiseAbs() +
                                moved * (map(h_ba).cwiseAbs() * carried.cwiseAbs() + map(h_bb).cwiseAbs());
      a_error_.assign(error.data(), error.data() + error.size());
      product_.a_error = a_error_;
    }
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
  Dofs columns_;
  std::size_t rows_, joint_;
  RowMatrixXc h_nj_;
  std::vector<double> a_error_;
  LineProduct product_;
};

}  // namespace

std::unique_ptr<EquationBuilder> make_direct(const Coordinates& coordinates, frf::FrfSystem& substructures,
                                             frf::FrfSystem& assembly) {
  return std::make_unique<Direct>(coordinates, substructures, assembly);
}

}  // namespace jointid::ident
