#include "ident/equations/equation_builder.hpp"

namespace jointid::ident {
namespace {

/// With A = [H_nj; H_jj] and B = [H_ba H_bb] the four equations are the four blocks of one product.
class MethodOne final : public EquationBuilder {
 public:
  MethodOne(const Coordinates& at, const EquationSet& use, frf::FrfSystem& substructures, frf::FrfSystem& assembly)
      : n_rows_(only_if(use.nn || use.nj, at.responses)),
        j_rows_(only_if(use.jj || use.jn, at.joint)),
        n_columns_(only_if(use.nn || use.jn, at.references)),
        j_columns_(only_if(use.nj || use.jj, at.joint)),
        joint_(at.joint.size()) {
    substructures_ = std::make_unique<Rectangle>(
        substructures,
        std::vector<Band>{{n_rows_, joined(only_if(use.nn, at.references), only_if(use.nj, at.joint))},
                          {at.joint, joined(n_columns_, j_columns_)}},
        joined(n_columns_, j_columns_));
    assembly_ = std::make_unique<Rectangle>(
        assembly,
        std::vector<Band>{{n_rows_, joined(only_if(use.nn, at.references), at.joint)},
                          {j_rows_, joined(only_if(use.jn, at.references), at.joint)}},
        joined(n_columns_, at.joint));
    product_.wanted[0][0] = use.nn;
    product_.wanted[0][1] = use.nj;
    product_.wanted[1][0] = use.jn;
    product_.wanted[1][1] = use.jj;
    product_.row_class.assign(n_rows_.size(), 0);
    product_.row_class.resize(n_rows_.size() + j_rows_.size(), 1);
    product_.column_class.assign(n_columns_.size(), 0);
    product_.column_class.resize(n_columns_.size() + j_columns_.size(), 1);
  }

  bool line(std::size_t i, minimise::LineProduct& out) override {
    const minimise::View sub = substructures_->line(i);
    const minimise::View asm_ = assembly_->line(i);
    const std::size_t rows = product_.row_class.size(), columns = product_.column_class.size();
    product_.frequency_hz = out.frequency_hz;
    product_.a = asm_.block(0, n_columns_.size(), rows, joint_);
    product_.b = sub.block(n_rows_.size(), 0, joint_, columns);
    product_.c1 = sub.block(0, 0, rows, columns);
    product_.c2 = asm_.block(0, 0, rows, columns);
    product_.wants_error_scale = out.wants_error_scale;
    out = product_;
    return true;
  }

  Dofs columns() const override { return joined(n_columns_, j_columns_); }

 private:
  Dofs n_rows_, j_rows_, n_columns_, j_columns_;
  std::size_t joint_;
  minimise::LineProduct product_;
};

}  // namespace

std::unique_ptr<EquationBuilder> make_method_one(const Coordinates& coordinates, const EquationSet& equations,
                                                 frf::FrfSystem& substructures, frf::FrfSystem& assembly) {
  return std::make_unique<MethodOne>(coordinates, equations, substructures, assembly);
}

}  // namespace jointid::ident
