#include "ident/likelihood/model/line_model.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/eigen.hpp"
#include "base/kernel.hpp"
#include "coupling/joint_loop.hpp"
#include "dense/blas.hpp"
#include "ident/likelihood/elimination/elimination_flops.hpp"
#include "ident/likelihood/rows/normal_kernels.hpp"

namespace jointid::ident {

bool LineModel::are_circular(const LineData& data) const {
  if (data.correlation && !data.correlation->is_circular()) return false;
  return std::ranges::all_of(
      std::array{&data.sub_jn, &data.sub_jj, &data.asm_jn, &data.asm_jj, &data.drop_nn}, [](const Channel* channel) {
        return std::ranges::all_of(channel->weight, [](const Complex& weight) { return weight.real() == weight.imag(); });
      });
}

/// Whether LineElimination is to be tried.
bool LineModel::eliminates(const JointImpedance& joint) {
  const std::size_t right_sides = (joint_unknowns_ > 0 ? joint.shapes().size() : 0) + unknowns_ - joint_unknowns_ + 1;
  if (numbers_ != Numbers::chosen) return numbers_ == Numbers::eliminated;
  if (pays_.first != right_sides) pays_ = {right_sides, elimination_pays(layout_, right_sides)};
  return pays_.second;
}

/// The line linearised by one of the ways without rows, which are made for the first that takes them; nullptr: it is none for these.
StructuredLine* LineModel::by_structure(const LineData& data, const LineState& state, const LineFactors& factors,
                                        const JointImpedance& joint) {
  if (data.correlation || numbers_ == Numbers::real || numbers_ == Numbers::complex) return nullptr;
  if (numbers_ == Numbers::chosen && !layout_.is_large()) return nullptr;
  if (!are_circular(data)) return nullptr;
  const JointImpedance* const with = joint_unknowns_ > 0 ? &joint : nullptr;
  if (eliminates(joint)) {
    if (!elimination_) elimination_ = std::make_unique<LineElimination>(layout_);
    if (elimination_->linearise(data, state, factors, with, terms_)) return elimination_.get();
  }
  if (numbers_ == Numbers::eliminated) return nullptr;
  if (!arrow_) arrow_ = std::make_unique<ArrowElimination>(layout_);
  arrow_->linearise(data, state, factors, with, terms_);
  return arrow_.get();
}

NormalRows::Run LineModel::column(std::size_t other) const {
  return {layout_.sub_jn_first[other], layout_.sub_jn_first[other + 1] - layout_.sub_jn_first[other]};
}

void LineModel::put(Complex coefficient) { row_[place_++] += coefficient; }

/// −left δY right
void LineModel::put_y(const Complex* left, const ComplexMatrix& right, Eigen::Index k) {
  const Complex* const r = right.col(k).data();
  Complex* out = row_.data() + place_;
  for (const auto [row, column] : layout_.sub_jj) {
    *out++ -= row == column ? product(left[row], r[row]) : product(left[row], r[column]) + product(left[column], r[row]);
  }
  place_ += layout_.sub_jj.size();
}

void LineModel::put_joint(const JointImpedance& joint, const Complex* left, const Complex* right) {
  if (joint_unknowns_ == 0) return;
  joint.sensitivity(left, right, row_.data() + place_);
  place_ += joint_unknowns_;
}

/// The measured value moves, not the predicted one.
void LineModel::put_systematic(std::size_t element, Complex residual) {
  if (terms_ == nullptr) return;
  for (std::size_t t = terms_->first[element]; t < terms_->first[element + 1]; ++t) {
    row_[place_ + terms_->terms[t].unknown] -= terms_->terms[t].derivative(residual);
  }
  place_ += terms_->unknowns;
}

void LineModel::emit(const Channel& channel, std::size_t i, Complex predicted, NormalRows::Run first,
                     NormalRows::Run second) {
  const Complex residual = channel.value[i] - predicted, weight = channel.weight[i];
  put_systematic(first_element_ + i, residual);
  row_[place_++] = {weight.real() == 0.0 ? 0.0 : residual.real(), weight.imag() == 0.0 ? 0.0 : residual.imag()};
  const minimise::Correlation::Place place =
      correlation_ ? correlation_->place(first_element_ + i) : minimise::Correlation::Place();
  if (place.group != minimise::Correlation::none) {
    put_correlated(place, weight, first, second);
  } else if (complex_) {
    for (std::size_t k = 0; k < place_; ++k) row_[k] *= weight.real();
    complex_rows_.add(row_.data(), first, second);
  } else {
    const std::size_t frfs = place_ - unknowns_ - 1;
    double* re = rows_.real();
    double* im = rows_.imaginary();
    for (std::size_t k = 0; k < frfs; ++k) {
      *re++ = weight.real() * row_[k].real();
      *re++ = weight.real() * -row_[k].imag();
      *im++ = weight.imag() * row_[k].imag();
      *im++ = weight.imag() * row_[k].real();
    }
    for (std::size_t k = frfs; k < place_; ++k) {
      *re++ = weight.real() * row_[k].real();
      *im++ = weight.imag() * row_[k].imag();
    }
    const auto doubled = [](NormalRows::Run run) { return NormalRows::Run{2 * run.first, 2 * run.count}; };
    rows_.add(doubled(first), doubled(second));
  }
  std::fill_n(row_.begin(), place_, Complex(0.0));
}

/// The row that is written, as CorrelatedRows weights it.
void LineModel::put_correlated(minimise::Correlation::Place place, Complex weight, NormalRows::Run first,
                               NormalRows::Run second) {
  const std::size_t variables = layout_.variables(), head = first.count + second.count, frfs = place_ - unknowns_ - 1;
  const auto weighted = [&](Complex z) { return Complex(weight.real() * z.real(), weight.imag() * z.imag()); };
  Complex* const out = correlated_rows_.row(place);
  for (std::size_t k = 0; k < frfs; ++k) {
    const std::size_t column = k < first.count ? first.first + k
                               : k < head      ? second.first + k - first.count
                                               : layout_.sub_jn.size() + k - head;
    if (complex_) {
      out[column] = weighted(row_[k]);
    } else {
      out[2 * column] = weighted(row_[k]);
      out[2 * column + 1] = weighted({-row_[k].imag(), row_[k].real()});
    }
  }
  for (std::size_t k = frfs; k < place_; ++k) out[(complex_ ? 1 : 2) * variables + k - frfs] = weighted(row_[k]);
}

/// A measured FRF with systematic errors, as a row.
void LineModel::put_systematic_prior(std::size_t variable, const Channel& channel, std::size_t i, Complex current) {
  const bool is_x = variable < layout_.sub_jn.size();
  const NormalRows::Run run = is_x ? column(layout_.sub_jn[variable].column) : NormalRows::Run{layout_.sub_jn.size(), 0};
  row_[variable - run.first] = 1.0;
  place_ = run.count + layout_.sub_jj.size() + joint_unknowns_;
  first_element_ = variable - i;
  emit(channel, i, current, is_x ? run : NormalRows::Run{}, {});
  prior_weight_.push_back(channel.weight[i].real());
  if (!complex_) prior_weight_.push_back(channel.weight[i].imag());
}

/// What the systematic errors of a measured FRF add to its row, which is there.
void LineModel::add_prior_terms(std::size_t variable, Complex residual, Complex weight) {
  const std::size_t last = rows_.columns() - 1, first = 2 * layout_.variables() + joint_unknowns_;
  const std::span terms = std::span(terms_->terms).subspan(terms_->first[variable], terms_->first[variable + 1] - terms_->first[variable]);
  const auto moved = [&](const SystematicTerm& term) {
    const Complex change = term.derivative(residual);
    return Complex(-weight.real() * change.real(), -weight.imag() * change.imag());
  };
  for (const SystematicTerm& one : terms) {
    const Complex by = moved(one);
    const std::size_t column = first + one.unknown;
    *rows_.block(column, 2 * variable) += weight.real() * by.real();
    *rows_.block(column, 2 * variable + 1) += weight.imag() * by.imag();
    *rows_.block(last, column) += by.real() * weight.real() * residual.real() + by.imag() * weight.imag() * residual.imag();
    for (const SystematicTerm& other : terms) {
      if (other.unknown < one.unknown) continue;
      const Complex with = moved(other);
      *rows_.block(first + other.unknown, column) += by.real() * with.real() + by.imag() * with.imag();
    }
  }
}

/// A measured FRF whose error depends on others, as a row of its own. False: it stands alone.
bool LineModel::put_correlated_prior(std::size_t variable, Complex residual, Complex weight) {
  const minimise::Correlation::Place place = correlation_ ? correlation_->place(variable) : minimise::Correlation::Place();
  if (place.group == minimise::Correlation::none) return false;
  Complex* const out = correlated_rows_.row(place);
  prior_weight_.push_back(weight.real());
  if (complex_) {
    out[variable] = weight.real();
    out[layout_.variables() + unknowns_] = weight.real() * residual;
    return true;
  }
  prior_weight_.push_back(weight.imag());
  out[2 * variable] = weight.real();
  out[2 * variable + 1] = Complex(0.0, weight.imag());
  out[2 * layout_.variables() + unknowns_] = {weight.real() * residual.real(), weight.imag() * residual.imag()};
  return true;
}

void LineModel::prepare(const ComplexMatrix& z, const LineState& state) {
  const auto n = at(layout_.joint);
  p_ = coupling::closed_loop(state.sub_jj, z);
  py_ = p_ * state.sub_jj;
  za_ = z * state.asm_jn;
  r_ = state.sub_jn - state.asm_jn - state.sub_jj * za_;
  pr_ = p_ * r_;
  if (layout_.asm_jj.empty()) return;
  c_ = ComplexMatrix::Identity(n, n) - z * state.asm_jj;
  rest_b_ = state.sub_jj * c_ - state.asm_jj;
  pr_b_ = p_ * rest_b_;
}

void LineModel::linearise(const LineData& data, const JointImpedance& joint, const ComplexMatrix& z, const LineState& state,
                          bool with_joint) {
  prepare(z, state);
  joint_unknowns_ = with_joint ? joint.columns().size() : 0;
  terms_ = with_joint ? data.terms.get() : nullptr;
  unknowns_ = joint_unknowns_ + (terms_ ? terms_->unknowns : 0);
  h_ = (p_.transpose() * z.transpose()) * state.sub_jn;  // hᵀ: N×n
  yh_ = state.sub_jn - state.sub_jj.transpose() * h_;
  const LineFactors factors{p_, py_, za_, h_, yh_, r_, c_, rest_b_};
  structured_ = by_structure(data, state, factors, joint);
  if (structured_ != nullptr) return;
  const bool pays = layout_.is_large() || data.correlation;
  complex_ = (numbers_ == Numbers::chosen ? pays : numbers_ != Numbers::real) && are_circular(data);
  const std::size_t others = unknowns_ + 1;
  row_.assign(layout_.variables() + others, 0.0);
  complex_ ? complex_rows_.reset(layout_.variables() + others, layout_.sub_jn.size())
           : rows_.reset(2 * layout_.variables() + others, 2 * layout_.sub_jn.size());
  correlation_ = data.correlation.get();
  if (correlation_) correlated_rows_.reset(*correlation_, (complex_ ? 1 : 2) * layout_.variables() + others);
  add_priors(data, state);
  if (are_plain()) {
    plain_rows_.add_to(rows_, data, state, factors, with_joint ? &joint : nullptr, terms_);
    return;
  }
  add_a(data, joint, state);
  if (!layout_.asm_jj.empty()) add_b(data, joint, state);
  add_d(data, joint, state);
  complex_ ? complex_rows_.finish() : rows_.finish();
  if (!correlation_) return;
  const auto size = at(rows_.columns());
  using Strided = Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>>;
  complex_ ? correlated_rows_.add_to(complex_rows_.normal())
           : correlated_rows_.add_to(Strided(rows_.values(), size, size, Eigen::OuterStride<>(at(rows_.stride()))));
}

void LineModel::add_prior(std::size_t variable, Complex residual, Complex weight, double guess) {
  if (put_correlated_prior(variable, residual, weight)) return;
  if (complex_) {
    Eigen::MatrixXcd& normal = complex_rows_.normal();
    const Eigen::Index last = normal.rows() - 1, v = at(variable);
    const double used = weight.real() == 0.0 ? guess : weight.real();
    prior_weight_.push_back(used);
    normal(v, v) += used * used;
    if (weight.real() == 0.0) return;
    normal(last, v) += used * used * std::conj(residual);
    normal(last, last) += used * used * std::norm(residual);
    return;
  }
  const std::size_t last = rows_.columns() - 1, stride = rows_.stride();
  double* normal = rows_.values();
  for (const auto& [part_weight, part] :
       {std::pair(weight.real(), residual.real()), std::pair(weight.imag(), residual.imag())}) {
    const std::size_t v = prior_weight_.size();
    const double used = part_weight == 0.0 ? guess : part_weight;
    prior_weight_.push_back(used);
    normal[v * stride + v] += used * used;
    if (part_weight == 0.0) continue;
    normal[v * stride + last] += part_weight * part_weight * part;
    normal[last * stride + last] += part_weight * part_weight * part * part;
  }
}

void LineModel::add_priors(const LineData& data, const LineState& state) {
  prior_weight_.clear();
  const double x_guess = guessed_weight(state.sub_jn), y_guess = guessed_weight(state.sub_jj);
  const auto is_systematic = [&](std::size_t variable, Complex weight) {
    return terms_ && terms_->has(variable) && weight.real() > 0.0 && weight.imag() > 0.0;
  };
  const auto add = [&](std::size_t variable, const Channel& channel, std::size_t i, Complex current, double guess) {
    const Complex residual = channel.value[i] - current, weight = channel.weight[i];
    const bool systematic = is_systematic(variable, weight);
    if (systematic && !are_plain()) {
      put_systematic_prior(variable, channel, i, current);
      return;
    }
    add_prior(variable, residual, weight, guess);
    if (systematic) add_prior_terms(variable, residual, weight);
  };
  for (std::size_t i = 0; i < layout_.sub_jn.size(); ++i)
    add(i, data.sub_jn, i, state.sub_jn(at(layout_.sub_jn[i].row), at(layout_.sub_jn[i].column)), x_guess);
  for (std::size_t i = 0; i < layout_.sub_jj.size(); ++i) {
    add(layout_.sub_jn.size() + i, data.sub_jj, i, state.sub_jj(at(layout_.sub_jj[i].row), at(layout_.sub_jj[i].column)),
        y_guess);
  }
}

void LineModel::add_a(const LineData& data, const JointImpedance& joint, const LineState& state) {
  std::vector<Complex> p_row(layout_.joint), left(layout_.joint);
  first_element_ = layout_.variables();
  for (std::size_t i = 0; i < layout_.asm_jn.size(); ++i) {
    if (data.asm_jn.weight[i] == Complex(0.0)) continue;
    const auto [p, k] = layout_.asm_jn[i];
    for (std::size_t m = 0; m < layout_.joint; ++m) {
      p_row[m] = p_(at(p), at(m));
      left[m] = -py_(at(p), at(m));
    }
    place_ = 0;
    for (std::size_t v = layout_.sub_jn_first[k]; v < layout_.sub_jn_first[k + 1]; ++v) put(p_row[layout_.sub_jn[v].row]);
    put_y(p_row.data(), za_, at(k));
    put_joint(joint, left.data(), state.asm_jn.col(at(k)).data());
    emit(data.asm_jn, i, state.asm_jn(at(p), at(k)) + pr_(at(p), at(k)), column(k), {});
  }
}

void LineModel::add_b(const LineData& data, const JointImpedance& joint, const LineState& state) {
  std::vector<Complex> minus_p_row(layout_.joint), left(layout_.joint);
  first_element_ = layout_.variables() + layout_.asm_jn.size();
  for (std::size_t i = 0; i < layout_.asm_jj.size(); ++i) {
    if (data.asm_jj.weight[i] == Complex(0.0)) continue;
    const auto [p, q] = layout_.asm_jj[i];
    for (std::size_t m = 0; m < layout_.joint; ++m) {
      minus_p_row[m] = -p_(at(p), at(m));
      left[m] = -py_(at(p), at(m));
    }
    place_ = 0;
    put_y(minus_p_row.data(), c_, at(q));
    put_joint(joint, left.data(), state.asm_jj.col(at(q)).data());
    emit(data.asm_jj, i, state.asm_jj(at(p), at(q)) + pr_b_(at(p), at(q)), {}, {});
  }
}

void LineModel::add_d(const LineData& data, const JointImpedance& joint, const LineState& state) {
  first_element_ = layout_.variables() + layout_.asm_jn.size() + layout_.asm_jj.size();
  for (std::size_t i = 0; i < layout_.drop_nn.size(); ++i) {
    if (data.drop_nn.weight[i] == Complex(0.0)) continue;
    const auto [r, k] = layout_.drop_nn[i];
    const Complex* h = h_.col(at(r)).data();
    place_ = 0;
    for (std::size_t v = layout_.sub_jn_first[r]; v < layout_.sub_jn_first[r + 1]; ++v)
      put(za_(at(layout_.sub_jn[v].row), at(k)));
    if (r == k) place_ = 0;
    for (std::size_t v = layout_.sub_jn_first[k]; v < layout_.sub_jn_first[k + 1]; ++v) put(h[layout_.sub_jn[v].row]);
    put_y(h, za_, at(k));
    put_joint(joint, yh_.col(at(r)).data(), state.asm_jn.col(at(k)).data());
    const Complex along = (h_.col(at(r)).transpose() * r_.col(at(k))).value();
    emit(data.drop_nn, i, predicted_difference(state, za_, {r, k}) + along, column(r), r == k ? NormalRows::Run{} : column(k));
  }
}

std::optional<ReducedLine> LineModel::reduce(double damping, bool answer) {
  if (structured_ != nullptr) return structured_->reduce(damping, answer);
  return complex_ ? reduce_complex(damping, answer) : reduce_real(damping, answer);
}

/// U = L Lᴴ of the FRFs, and what is real in the Schur complement of the joint's unknowns, which are.
std::optional<ReducedLine> LineModel::reduce_complex(double damping, bool answer) {
  const auto v = at(layout_.variables()), p = at(unknowns_);
  const Eigen::MatrixXcd& normal = complex_rows_.normal();
  factor_ = normal.topLeftCorner(v, v);
  for (Eigen::Index i = 0; i < v; ++i) {
    const double weight = prior_weight_[static_cast<std::size_t>(i)];
    factor_(i, i) += damping * weight * weight;
  }
  scale_ = factor_.diagonal().real().cwiseSqrt().cwiseInverse();
  for (Eigen::Index j = 0; j < v; ++j) factor_.col(j).tail(v - j).array() *= scale_.tail(v - j).array() * scale_[j];
  if (!dense::cholesky_in_place(factor_)) return std::nullopt;
  right_ = scale_.asDiagonal() * normal.bottomLeftCorner(p + 1, v).adjoint();
  dense::solve_lower(factor_, right_);
  Eigen::MatrixXcd schur = normal.bottomRightCorner(p + 1, p + 1);
  schur.triangularView<Eigen::Lower>() -= right_.adjoint() * right_;
  ReducedLine out;
  const Eigen::MatrixXd real = schur.real();
  out.information = real.topLeftCorner(p, p).selfadjointView<Eigen::Lower>();
  out.gradient = real.bottomLeftCorner(1, p).transpose();
  out.cost = real(p, p);
  if (!std::isfinite(out.cost)) return std::nullopt;
  if (!answer) return out;
  dense::solve_lower_adjoint(factor_, right_);
  right_ = scale_.asDiagonal() * right_;
  Eigen::MatrixXd parts(2 * v, p + 1);  // real and imaginary part of every FRF in turn
  for (Eigen::Index i = 0; i < v; ++i) {
    parts.row(2 * i) = right_.row(i).real();
    parts.row(2 * i + 1) = right_.row(i).imag();
  }
  out.back = std::make_shared<WayBack>(parts.leftCols(p));
  out.own = parts.col(p);
  return out;
}

std::optional<ReducedLine> LineModel::reduce_real(double damping, bool answer) {
  const std::size_t v = 2 * layout_.variables(), size = rows_.columns(), stride = rows_.stride();
  make_room(real_factor_, rows_.room());
  for (std::size_t j = 0; j < size; ++j) {
    const std::size_t from = j * stride + lower_part(j);
    std::copy_n(rows_.values() + from, stride - lower_part(j), real_factor_.data() + from);
  }
  for (std::size_t i = 0; i < v; ++i) real_factor_[i * stride + i] += damping * prior_weight_[i] * prior_weight_[i];
  if (!eliminate(real_factor_.data(), stride, v, size)) return std::nullopt;
  const auto p = at(unknowns_);
  const Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>> schur(real_factor_.data() + v * stride + v, p + 1, p + 1,
                                                                         Eigen::OuterStride<>(at(stride)));
  ReducedLine out;
  out.information = schur.topLeftCorner(p, p).selfadjointView<Eigen::Lower>();
  out.gradient = schur.bottomLeftCorner(1, p).transpose();
  out.cost = schur(p, p);
  if (!std::isfinite(out.cost)) return std::nullopt;
  if (!answer) return out;
  make_room(solved_, v * widths_of(size - v));
  solve_eliminated(real_factor_.data(), stride, v, size, solved_.data());
  const Eigen::Map<const RowMatrixXd, 0, Eigen::OuterStride<>> solved(solved_.data(), at(v), p + 1,
                                                                      Eigen::OuterStride<>(at(widths_of(size - v))));
  out.back = std::make_shared<WayBack>(solved.leftCols(p));
  out.own = solved.col(p);
  return out;
}

LineStep LineModel::own_step(const LineStep& gradient) const {
  if (structured_ != nullptr) return structured_->own_step(gradient);
  if (!complex_) {
    LineStep step = gradient;
    solve_by_factor(real_factor_.data(), rows_.stride(), static_cast<std::size_t>(step.size()), step.data());
    return step;
  }
  LineStep step(gradient.size());
  const auto v = gradient.size() / 2;
  const Eigen::Map<const Eigen::VectorXcd> complex_gradient(reinterpret_cast<const Complex*>(gradient.data()), v);
  Eigen::MatrixXcd parts = scale_.asDiagonal() * complex_gradient;
  dense::solve_lower(factor_, parts);
  dense::solve_lower_adjoint(factor_, parts);
  Eigen::Map<Eigen::VectorXcd>(reinterpret_cast<Complex*>(step.data()), v) = scale_.asDiagonal() * parts.col(0);
  return step;
}

void LineModel::advance(const LineStep& step, const ComplexMatrix& dz, LineState& state) const {
  ComplexMatrix dx = ComplexMatrix::Zero(state.sub_jn.rows(), state.sub_jn.cols());
  ComplexMatrix dy = ComplexMatrix::Zero(state.sub_jj.rows(), state.sub_jj.cols());
  move(layout_, step, 1.0, dx, dy);
  const ComplexMatrix da = pr_ + p_ * (dx - dy * za_) - py_ * (dz * state.asm_jn);
  if (!layout_.asm_jj.empty()) state.asm_jj += pr_b_ + p_ * (dy * c_) - py_ * (dz * state.asm_jj);
  state.asm_jn += da;
  state.sub_jn += dx;
  state.sub_jj += dy;
}

}  // namespace jointid::ident
