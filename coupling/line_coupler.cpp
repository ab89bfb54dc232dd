#include "coupling/line_coupler.hpp"

#include <limits>
#include <numeric>

#include "base/complex.hpp"
#include "base/eigen.hpp"
#include "base/statistics.hpp"
#include "coupling/joint_errors.hpp"
#include "coupling/jumps.hpp"
#include "coupling/truncation.hpp"
#include "dense/lu.hpp"

namespace jointid::coupling {
namespace {

constexpr double singular = 16.0 * std::numeric_limits<double>::epsilon();  ///< 1/condition, per condition

Conditions met(const Conditions& all, const std::vector<bool>& left_out) {
  if (left_out.empty()) return all;
  Conditions out;
  for (std::size_t p = 0; p < all.size(); ++p) {
    if (!left_out[p]) out.push_back(all[p]);
  }
  return out;
}

/// H with the joint, and what that did to H.
struct WithJoint {
  ComplexMatrix h, z;
};

WithJoint insert_joint(const MatrixRef& h, const LayoutJoint& joint, double omega) {
  if (joint.at.empty()) return {h, {}};
  ComplexMatrix z = joint.dynamic_stiffness(omega);
  return {with_joint(h, joint.at, z), std::move(z)};
}

Wanted first(Index count) {
  std::vector<Index> all(static_cast<std::size_t>(count));
  std::iota(all.begin(), all.end(), Index{0});
  return {all, all};
}

/// E|δS|² of the elements of S; FRFs there and back that are one measurement have one error.
RealMatrix jump_variance(const MatrixRef& h, const LineVariance& variance, const Conditions& conditions) {
  const auto m = at(conditions.size());
  RealMatrix out = RealMatrix::Zero(m, m);
  const auto of = [&](Index r, Index c) { return variance.real(r, c) + variance.imaginary(r, c); };
  for (Index p = 0; p < m; ++p) {
    for (Index q = 0; q < m; ++q) {
      const Condition &row = conditions[static_cast<std::size_t>(p)], &column = conditions[static_cast<std::size_t>(q)];
      out(p, q) = of(row.first, column.first);
      if (column.second) out(p, q) += of(row.first, *column.second);
      if (row.second) out(p, q) += of(*row.second, column.first);
      if (row.second && column.second) out(p, q) += of(*row.second, *column.second);
      const bool pair = p == q && row.second && is_one_measurement(h(row.first, *row.second), h(*row.second, row.first));
      if (pair) out(p, q) += 2.0 * of(row.first, *row.second);
    }
  }
  return out;
}

class Line {
 public:
  Line(const MatrixRef& h, const LineVariance& variance, double frequency_hz, const LineFrame& frame, const Layout& layout,
       const Options& options)
      : parts_(h),
        variance_(variance),
        frame_(frame),
        layout_(layout),
        options_(options),
        omega_(angular(frequency_hz)),
        count_(at(layout.connected.size())),
        joint_(insert_joint(h, layout.joint, omega_)),
        conditions_(met(layout.conditions, options.left_out)),
        s_(jump_receptance(joint_.h, conditions_)) {}

  CoupledLine couple() {
    CoupledLine out;
    if (!measured()) return unusable(nan);
    const double reciprocal = dense::ComplexLu(s_).reciprocal_condition();
    out.record.condition = 1.0 / reciprocal;
    out.record.kept = conditions_.size();
    const bool may_drop = options_.threshold != Threshold::none;
    if (!may_drop && !(reciprocal > singular * static_cast<double>(conditions_.size()))) return unusable(out.record.condition);
    ComplexMatrix inverse;
    if (!truncates()) {
      run(out);
      if (options_.uncertainty) inverse = dense::inverse(jump_receptance(joint_.h, conditions_));
    } else {
      Truncation truncation = truncate();
      out.record.kept = static_cast<std::size_t>(truncation.kept);
      out.record.sigma.assign(truncation.sigma.begin(), truncation.sigma.end());
      out.record.limit.assign(truncation.limit.begin(), truncation.limit.end());
      inverse = std::move(truncation.inverse);
      out.frf = one_step<ComplexMatrix>(joint_.h, conditions_, frame_.wanted,
                                        [&](const ComplexMatrix&, const ComplexMatrix& y) { return ComplexMatrix(inverse * y); });
    }
    if (!options_.uncertainty) return out;
    const Sensitivity conditions = sensitivity(joint_.h, conditions_, inverse, frame_.wanted, count_);
    const Sensitivity at =
        layout_.joint.at.empty() ? conditions : before(conditions, parts_, layout_.joint.at, joint_.z, frame_.wanted);
    out.variance = variance_of(out.frf, conditions, at);
    if (frame_.with_errors) out.errors = error_sums(at, parts_, variance_, frame_.wanted, frame_.twin);
    return out;
  }

 private:
  /// What is connected has to be known, or nothing can be said.
  bool measured() const {
    return joint_.h.topLeftCorner(count_, count_).allFinite() && (joint_.z.size() == 0 || joint_.z.allFinite());
  }

  bool truncates() const { return options_.threshold != Threshold::none && options_.threshold != Threshold::alpha; }

  CoupledLine unusable(double condition) const {
    CoupledLine out;
    const auto rows = at(frame_.wanted.rows.size()), columns = at(frame_.wanted.columns.size());
    out.frf = ComplexMatrix::Constant(rows, columns, Complex(nan, nan));
    if (frame_.with_errors) out.errors.terms.resize(static_cast<std::size_t>(rows * columns));
    if (options_.uncertainty) {
      out.variance = {RealMatrix::Constant(rows, columns, nan), RealMatrix::Constant(rows, columns, nan)};
      if (!variance_.covariance.empty()) {
        out.variance.covariance.assign(static_cast<std::size_t>(columns), ComplexMatrix::Constant(rows, rows, Complex(nan, nan)));
      }
    }
    out.record.condition = condition;
    out.record.usable = false;
    if (options_.method == Method::mtc) out.record.alpha.assign(conditions_.size(), nan);
    if (truncates()) out.record.sigma.assign(conditions_.size(), nan), out.record.limit = out.record.sigma;
    return out;
  }

  void run(CoupledLine& out) {
    switch (options_.method) {
      case Method::gic:
        out.frf = gic(joint_.h, conditions_, frame_.wanted);
        break;
      case Method::rc:
        out.frf = rc(joint_.h, conditions_, frame_.wanted, frame_.row_body, frame_.column_body);
        break;
      case Method::grc:
        out.frf = grc(joint_.h, conditions_, frame_.wanted);
        break;
      case Method::pcc:
        out.frf = pcc(joint_.h, conditions_, frame_.wanted);
        break;
      case Method::mtc:
        run_mtc(out);
        break;
    }
  }

  void run_mtc(CoupledLine& out) {
    MtcResult result = mtc(joint_.h, conditions_, frame_.wanted, options_.threshold == Threshold::alpha ? options_.alpha : -1.0);
    out.frf = std::move(result.frf);
    out.record.alpha = std::move(result.alpha);
    std::vector<bool> skipped = result.coupled;
    skipped.flip();
    conditions_ = met(conditions_, skipped);
    out.record.kept = conditions_.size();
  }

  Truncation truncate() const {
    if (options_.threshold == Threshold::fixed) return truncate_fixed(s_, options_.epsilon);
    if (options_.threshold == Threshold::picard) return truncate_picard(s_, row_jumps(joint_.h, conditions_, frame_.wanted.columns));
    return truncate_noise(s_, jump_variance(joint_.h, connected_variance(), conditions_));
  }

  /// Of the connected coordinates' FRFs, with the joint.
  LineVariance connected_variance() const {
    const Wanted all = first(count_);
    const auto corner = [&](const auto& m) { return m.topLeftCorner(count_, count_).eval(); };
    if (layout_.joint.at.empty()) return {corner(variance_.real), corner(variance_.imaginary)};
    const Sensitivity identity{ComplexMatrix::Identity(count_, count_), ComplexMatrix::Identity(count_, count_)};
    return propagate(before(identity, parts_, layout_.joint.at, joint_.z, all), parts_, variance_, all, frame_.twin);
  }

  LineVariance variance_of(const ComplexMatrix& frf, const Sensitivity& conditions, const Sensitivity& at) const {
    LineVariance out = propagate(at, parts_, variance_, frame_.wanted, frame_.twin);
    if (!layout_.joint.by_unknown.empty()) {
      add_joint_errors({conditions, at, joint_.h, layout_.joint, omega_, frame_.wanted}, variance_.with_joint, out);
    }
    // Cancellation may leave a variance of nothing a hair below zero.
    const auto not_negative = [](double v) { return v < 0.0 ? 0.0 : v; };
    out.real = out.real.unaryExpr(not_negative).eval();
    out.imaginary = out.imaginary.unaryExpr(not_negative).eval();
    for (Index c = 0; c < frf.cols(); ++c) {
      for (Index r = 0; r < frf.rows(); ++r) {
        if (std::isnan(frf(r, c).real())) out.real(r, c) = out.imaginary(r, c) = nan;
      }
    }
    return out;
  }

  const MatrixRef& parts_;
  const LineVariance& variance_;
  const LineFrame& frame_;
  const Layout& layout_;
  const Options& options_;
  double omega_;
  Index count_;
  WithJoint joint_;
  Conditions conditions_;
  ComplexMatrix s_;
};

}  // namespace

CoupledLine couple_line(const MatrixRef& h, const LineVariance& variance, double frequency_hz, const LineFrame& frame,
                        const Layout& layout, const Options& options) {
  return Line(h, variance, frequency_hz, frame, layout, options).couple();
}

}  // namespace jointid::coupling
