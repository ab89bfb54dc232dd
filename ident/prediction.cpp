#include "ident/prediction.hpp"

#include <Eigen/LU>
#include <numbers>

#include "ident/chunk_pipeline.hpp"
#include "ident/eigen_view.hpp"
#include "ident/rectangle.hpp"
#include "ident/row_expander.hpp"

namespace jointid::ident {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using RowMatrixXd = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Z_j(ω) of thesis eq. (6.28).
MatrixXcd impedance(const Matrices& matrices, std::size_t n, double omega) {
  MatrixXcd z = MatrixXcd::Zero(static_cast<Index>(n), static_cast<Index>(n));
  for (const auto& [kind, matrix] : matrices) {
    const Complex factor = impedance_factor(kind, omega);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) z(static_cast<Index>(i), static_cast<Index>(j)) += factor * matrix[i][j];
    }
  }
  return z;
}

const Matrices* matrices_at(const std::vector<BandMatrices>& bands, double frequency_hz) {
  for (const BandMatrices& band : bands) {
    if (!band.band_hz || (frequency_hz >= (*band.band_hz)[0] && frequency_hz < (*band.band_hz)[1])) {
      return &band.matrices;
    }
  }
  return nullptr;
}

Rectangle whole(frf::FrfSystem& system, const Dofs& rows, const Dofs& columns) {
  return {system, {{rows, columns}}, columns};
}

/// DOFs of `dofs` followed by the joint DOFs that are not among them.
Dofs with_joint(const Dofs& dofs, const Dofs& joint) {
  return frf::find_coordinate(dofs, joint.front()) == frf::npos ? joined(dofs, joint) : dofs;
}

/// Predicts chunks of lines and adds their errors up in order.
class Predictor final : public ChunkWorker {
 public:
  Predictor(Plan& plan, const std::vector<BandMatrices>& bands, DecibelError& total)
      : plan_(plan),
        bands_(bands),
        total_(total),
        substructures_(whole(*plan.substructures, with_joint(plan.predicted_responses, plan.coordinates.joint),
                             with_joint(plan.predicted_references, plan.coordinates.joint))),
        assembly_(whole(*plan.assembly, plan.predicted_responses, plan.predicted_references)) {}

  void read(std::size_t first, std::size_t last) override {
    std::vector<std::size_t> substructure_lines, assembly_lines;
    for (std::size_t i = first; i < last; ++i) {
      substructure_lines.push_back(plan_.lines[i].substructures);
      assembly_lines.push_back(plan_.lines[i].assembly);
    }
    substructures_.read(substructure_lines);
    assembly_.read(assembly_lines);
  }

  void work(std::size_t first, std::size_t last) override {
    error_ = {};
    for (std::size_t i = first; i < last; ++i) {
      const double frequency = plan_.lines[i].frequency_hz;
      const Matrices* matrices = matrices_at(bands_, frequency);
      if (matrices != nullptr) add(*matrices, frequency, substructures_.line(i - first), assembly_.line(i - first));
    }
  }

  void merge() override {
    total_.sum_of_squares += error_.sum_of_squares;
    total_.entries += error_.entries;
  }

 private:
  void add(const Matrices& matrices, double frequency_hz, const View& h, const View& measured) {
    const std::size_t n = plan_.coordinates.joint.size();
    const std::size_t rows = measured.rows, columns = measured.columns;
    const View h_b = h.block(h.rows - n, 0, n, columns);   // H_b:, to the predicted references
    const View h_to = h.block(0, h.columns - n, rows, n);  // H_:b, from the joint
    const View h_bb = h.block(h.rows - n, h.columns - n, n, n);
    const MatrixXcd z = impedance(matrices, n, 2.0 * std::numbers::pi * frequency_hz);
    const MatrixXcd p = MatrixXcd::Identity(z.rows(), z.cols()) + z * map(h_bb);
    const RowMatrixXc left = map(h_to) * p.partialPivLu().solve(z);
    const RowMatrixXd left_re = left.real(), left_im = left.imag();
    RowMatrixXd right_re = RowMatrixXd::Zero(map(h_b).rows(), static_cast<Index>(padded(columns))), right_im = right_re;
    right_re.leftCols(map(h_b).cols()) = map(h_b).real();
    right_im.leftCols(map(h_b).cols()) = map(h_b).imag();
    add_decibel_error(h.block(0, 0, rows, columns), left_re.data(), left_im.data(), right_re.data(), right_im.data(), n,
                      measured, error_);
  }

  Plan& plan_;
  const std::vector<BandMatrices>& bands_;
  DecibelError& total_;
  DecibelError error_;
  Rectangle substructures_, assembly_;
};

}  // namespace

DecibelError predict(Plan& plan, const std::vector<BandMatrices>& bands, const Control& control) {
  DecibelError total;
  const std::size_t chunk = chunk_lines(plan.builder->entries_per_line());
  std::vector<std::unique_ptr<ChunkWorker>> workers;
  for (std::size_t i = worker_count(plan.lines.size(), chunk, control.threads); i-- > 0;) {
    workers.push_back(std::make_unique<Predictor>(plan, bands, total));
  }
  run_chunks(plan.lines.size(), chunk, "predicting", workers, control);
  return total;
}

}  // namespace jointid::ident
