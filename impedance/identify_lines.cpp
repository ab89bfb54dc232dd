#include "impedance/identify_lines.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <tuple>

#include "base/parallel.hpp"
#include "base/statistics.hpp"
#include "ident/identify.hpp"
#include "ident/likelihood/data/likelihood_plan.hpp"
#include "ident/likelihood/data/systematic_plan.hpp"
#include "ident/scene/scene_failure.hpp"
#include "impedance/line/closed_forms.hpp"
#include "impedance/line/line_fit.hpp"
#include "impedance/line_findings.hpp"
#include "impedance/line_laws.hpp"

namespace jointid::impedance {
namespace {

using restrictions::Kind;

Eigen::MatrixXd halves(const LineScene& scene) {
  const auto size = static_cast<Eigen::Index>(scene.scene.joints.front().dofs.size());
  if (scene.facing.empty()) return Eigen::MatrixXd::Identity(size, size);
  Eigen::MatrixXd t = Eigen::MatrixXd::Zero(size, size / 2);
  for (std::size_t i = 0; i < scene.facing.size(); ++i) {
    t(static_cast<Eigen::Index>(scene.facing[i].first), static_cast<Eigen::Index>(i)) = 1.0;
    t(static_cast<Eigen::Index>(scene.facing[i].second), static_cast<Eigen::Index>(i)) = -1.0;
  }
  return t;
}

/// "K.z1_2" as "z(1,2)", "K.m1" as "m(1)", "K(1,2)" as "Z(1,2)", "K.a" as "Z.a".
std::string element_name(const std::string& unknown, Structure structure) {
  const bool own = structure == Structure::massless || structure == Structure::masses;
  if (!own) return "Z" + unknown.substr(1);
  std::string text = unknown.substr(3);
  std::ranges::replace(text, '_', ',');
  return std::string(1, unknown[2]) + "(" + text + ")";
}

/// Elements of a structure, from the K of its restriction.
void add_elements(const restrictions::Restriction& all, Structure structure, WayResult& out) {
  const auto size = static_cast<Eigen::Index>(all.dofs.size());
  out.structure = structure;
  for (const restrictions::Unknown& unknown : all.unknowns) {
    if (unknown.kind != Kind::stiffness) continue;
    out.elements.push_back({element_name(unknown.name, structure), unknown.unit});
    out.basis.push_back(Eigen::MatrixXd::Zero(size, size));
  }
  for (const restrictions::MatrixTerms& matrix : all.matrices) {
    if (matrix.kind != Kind::stiffness) continue;
    for (const restrictions::Term& term : matrix.terms) {
      out.basis[term.unknown](static_cast<Eigen::Index>(term.row), static_cast<Eigen::Index>(term.column)) += term.coefficient;
    }
  }
}

LineScene with_structure(const LineScene& scene, Structure structure) {
  LineScene out = scene;
  out.structure = structure;
  if (structure == Structure::symmetric) out.facing.clear();
  set_structure(out);
  return out;
}

/// Between halves for those closed forms that are of z, whole for the others.
Structure structure_of(Way way, const LineScene& scene) {
  switch (way) {
    case Way::likelihood:
    case Way::weighed:
      return scene.structure;
    case Way::average:
    case Way::off_diagonal:
    case Way::relative:
      return Structure::massless;
    case Way::nn:
      return scene.structure == Structure::massless ? Structure::massless : Structure::symmetric;
    default:
      return Structure::symmetric;
  }
}

WayResult empty_result(Way way, const LineScene& scene) {
  WayResult out;
  out.way = way;
  const Structure structure = structure_of(way, scene);
  if (structure == Structure::massless && scene.facing.empty()) {
    ident::fail(scene.scene, "[joint] way", "way \"" + name(way) + "\" is one of joints between facing DOFs",
                "write lines = \"massless\", or another way");
  }
  add_elements(restrictions::build({with_structure(scene, structure).scene.joints.front()}), structure, out);
  return out;
}

/// All lines of a plan with what fits them.
class Lines {
 public:
  Lines(const LineScene& scene, const ident::Plan& plan, const ident::Control& control)
      : scene_(scene), plan_(plan), control_(control), t_(halves(scene)), nn_(t_), threads_(threads_or_cores(control.threads)) {
    if (scene.structure != Structure::massless) nn_ = Eigen::MatrixXd::Identity(t_.rows(), t_.rows());
    ident::Observations& observations = *ident::likelihood_plan(plan)->observations;
    observations.read(plan.lines, [&](std::size_t done) { watch("reading", done); });
    data_ = &observations.lines();
    layout_ = &observations.layout();
    blocks_.resize(data_->size());
    each("reading", [&](std::size_t i, ident::LineModel&) { blocks_[i] = blocks_of(*layout_, (*data_)[i]); });
  }

  /// Fits that follow begin from these values alone, and end with a last step of `tolerance` standard deviations.
  void go_on_from(const WayResult& result, double tolerance) {
    tolerance_ = tolerance;
    reached_.clear();
    for (const auto& line : result.lines)
      reached_.push_back(line ? triangle_of(matrix_of(result.basis, line->z)) : Eigen::VectorXcd());
  }

  std::size_t size() const { return data_->size(); }
  const LineBlocks& blocks(std::size_t i) const { return blocks_[i]; }

  std::optional<LineValue> closed_form(Way way, std::size_t i, const Basis& basis) const {
    const LineBlocks& line = blocks_[i];
    switch (way) {
      case Way::average:
        return average(line, t_);
      case Way::off_diagonal:
        return off_diagonal(line, t_);
      case Way::relative:
        return relative(line, t_);
      case Way::extended:
        return extended(line);
      case Way::nj:
        return from_nj(line);
      case Way::nn:
        return from_nn(line, nn_);
      case Way::weighed: {
        const auto full = primal(line);
        return full ? weighed(*full, basis) : std::nullopt;
      }
      default:
        return primal(line);
    }
  }

  void run_closed_form(WayResult& result) const {
    result.lines.resize(size());
    each("closed form", [&](std::size_t i, ident::LineModel&) { result.lines[i] = closed_form(result.way, i, result.basis); });
  }

  /// Fits every line; the number of lines that came to their end from others' values, and of those that came to none. With `wider`, all
  /// elements of a symmetric Z, falls() are theirs.
  std::pair<std::size_t, std::size_t> run_likelihood(const restrictions::Restriction& restriction, WayResult& result,
                                                     const restrictions::Restriction* wider = nullptr) {
    std::vector<LineFit> fits(size());
    each("likelihood", [&](std::size_t i, ident::LineModel& model) { fits[i] = best_fit(i, restriction, result.basis, model); });
    require_some(fits);
    const std::size_t restarted = restart(restriction, fits);
    if (wider != nullptr) take_falls(*wider, result.basis, fits);
    std::size_t failed = 0;
    for (LineFit& fit : fits) {
      const bool usable = fit.value.z.size() > 0 && fit.value.z.allFinite();
      failed += usable && fit.converged ? 0 : 1;
      result.lines.push_back(usable ? std::optional(std::move(fit.value)) : std::nullopt);
    }
    return {restarted, failed};
  }

  /// By how much χ² of the lines would fall with a symmetric Z, to first order; NaN where that is not known.
  const std::vector<double>& falls() const { return falls_; }

 private:
  void take_falls(const restrictions::Restriction& wider, const Basis& basis, const std::vector<LineFit>& fits_of) {
    falls_.assign(size(), nan);
    each("likelihood", [&](std::size_t i, ident::LineModel& model) {
      const LineFit& fit = fits_of[i];
      if (fit.value.z.size() == 0 || !fit.value.z.allFinite() || !fit.converged) return;
      const Eigen::VectorXcd z = triangle_of(matrix_of(basis, fit.value.z));
      if (const auto fall = fall_with((*data_)[i], joint(wider, i), z, fit, model)) falls_[i] = *fall;
    });
  }

  void watch(const char* stage, std::size_t done) const {
    stop_if(control_.interrupted);
    if (control_.progress) control_.progress(stage, done, plan_.lines.size());
  }

  void each(const char* stage, const std::function<void(std::size_t, ident::LineModel&)>& work) const {
    std::atomic<std::size_t> next = 0;
    for_each_index(threads_, threads_, [&](std::size_t) {
      ident::LineModel model(*layout_);
      for (std::size_t i; (i = next++) < data_->size();) {
        watch(stage, i);
        work(i, model);
      }
    });
  }

  ident::JointImpedance joint(const restrictions::Restriction& restriction, std::size_t i) const {
    std::vector<std::size_t> all(restriction.unknowns.size());
    for (std::size_t u = 0; u < all.size(); ++u) all[u] = u;
    return {restriction, all, all, 1.0, (*data_)[i].omega};
  }

  /// What a fit may begin from: where another ended (of a symmetric Z), or closed forms, best guess first, until `use` returns true.
  template <class Use>
  void for_each_start(std::size_t i, const Basis& basis, const Use& use) const {
    if (!reached_.empty()) {
      if (reached_[i].size() == at(basis.size())) use(reached_[i]);
      return;
    }
    bool any = false, done = false;
    const auto try_with = [&](const std::optional<LineValue>& from, const Basis& of) {
      if (!from || !from->z.allFinite()) return;
      const Eigen::VectorXcd whole = triangle_of(matrix_of(of, from->z));
      LineValue full{.z = whole, .covariance = from->covariance};
      if (full.covariance.rows() != 2 * whole.size()) full.covariance = plain_covariance(whole);
      auto found = weighed(full, basis);
      if (!found || !found->z.allFinite()) found = weighed({.z = whole, .covariance = plain_covariance(whole)}, basis);
      if (!found || !found->z.allFinite()) return;
      any = true;
      done = use(found->z);
    };
    const Basis full = symmetric_basis(layout_->joint);
    try_with(primal(blocks_[i]), full);
    if (!done) try_with(extended(blocks_[i]), full);
    if (any) return;
    try_with(from_nj(blocks_[i]), full);
    if (done) return;
    Basis between;
    for (const Eigen::MatrixXd& e : symmetric_basis(static_cast<std::size_t>(nn_.cols())))
      between.push_back(nn_ * e * nn_.transpose());
    try_with(from_nn(blocks_[i], nn_), between);
  }

  static Eigen::MatrixXd plain_covariance(const Eigen::VectorXcd& z) {
    const double size = z.cwiseAbs2().mean();
    Eigen::VectorXd parts(2 * z.size());
    parts << z.cwiseAbs2(), z.cwiseAbs2();
    return (parts.array() + 1e-6 * size).matrix().asDiagonal();
  }

  bool fits(const LineFit& fit) const {
    return fit.converged && (!(fit.value.freedom > 0.0) || fit.value.chi_square <= chi_square_quantile(fit.value.freedom, 4.0));
  }

  LineFit best_fit(std::size_t i, const restrictions::Restriction& restriction, const Basis& basis,
                   ident::LineModel& model) const {
    LineFit best;
    const ident::JointImpedance of = joint(restriction, i);
    for_each_start(i, basis, [&](const Eigen::VectorXcd& start) {
      LineFit fit = fit_line((*data_)[i], of, start, model, tolerance_);
      if (best.value.z.size() == 0 || is_better(fit, best)) best = std::move(fit);
      return fits(best);
    });
    return best;
  }

  static bool is_better(const LineFit& one, const LineFit& other) {
    if (!std::isfinite(one.value.chi_square)) return false;
    return !std::isfinite(other.value.chi_square) ||
           one.value.chi_square < other.value.chi_square - 1e-6 * (1.0 + other.value.chi_square) ||
           (one.converged && !other.converged && one.value.chi_square <= other.value.chi_square);
  }

  /// Lines that do not fit once more from the median of their neighbours' values.
  std::size_t restart(const restrictions::Restriction& restriction, std::vector<LineFit>& fits_of) const {
    constexpr std::size_t beside = 3;
    const std::vector<LineFit> before = fits_of;
    std::atomic<std::size_t> mended = 0;
    each("likelihood", [&](std::size_t i, ident::LineModel& model) {
      if (before[i].value.z.size() > 0 && fits(before[i])) return;
      std::vector<const Eigen::VectorXcd*> near;
      for (std::size_t k = i - std::min(i, beside); k < std::min(i + beside + 1, size()); ++k) {
        if (k != i && before[k].value.z.size() > 0 && before[k].value.z.allFinite()) near.push_back(&before[k].value.z);
      }
      if (near.empty()) return;
      Eigen::VectorXcd start(near.front()->size());
      for (Eigen::Index t = 0; t < start.size(); ++t) {
        std::vector<double> re, im;
        for (const Eigen::VectorXcd* z : near) {
          re.push_back((*z)(t).real());
          im.push_back((*z)(t).imag());
        }
        start(t) = {median(re), median(im)};
      }
      LineFit fit = fit_line((*data_)[i], joint(restriction, i), start, model, tolerance_);
      if (before[i].value.z.size() > 0 && !is_better(fit, before[i])) return;
      fits_of[i] = std::move(fit);
      ++mended;
    });
    return mended;
  }

  void require_some(const std::vector<LineFit>& fits_of) const {
    if (std::ranges::any_of(fits_of, [](const LineFit& fit) { return fit.value.z.size() > 0; })) return;
    ident::fail(scene_.scene, "[data]", "no line has the FRFs that a way to Z begins from",
                "measure both systems at the joint, or H(n,j) of both at as many other DOFs as the joint has, or H(n,n) of both "
                "and H(j,n) of the parts. Else identify matrices ([joint.stiffness])");
  }

  const LineScene& scene_;
  const ident::Plan& plan_;
  const ident::Control& control_;
  Eigen::MatrixXd t_;   ///< facing halves, or I
  Eigen::MatrixXd nn_;  ///< the same where the joint has no mass, else I
  std::size_t threads_;
  double tolerance_ = 1e-7;
  std::vector<double> falls_;
  std::vector<Eigen::VectorXcd> reached_;  ///< elements of a symmetric Z of each line; empty: closed forms
  const std::vector<ident::LineData>* data_ = nullptr;
  const ident::LineLayout* layout_ = nullptr;
  std::vector<LineBlocks> blocks_;
};

void add_conditions(const Lines& lines, IdentifiedLines& out) {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const LineBlocks& line = lines.blocks(i);
    const auto size = at(line.joint);
    const auto condition = [&](const Eigen::MatrixXd& known, const Eigen::MatrixXcd& y) {
      return known.bottomRightCorner(size, size).minCoeff() > 0.0 ? condition_of(y) : nan;
    };
    out.condition_substructures.push_back(condition(line.known_substructures, line.y_substructures()));
    out.condition_assembly.push_back(condition(line.known_assembly, line.y_assembly()));
  }
}

void add_receptances(const Lines& lines, IdentifiedLines& out) {
  for (std::size_t i = 0; i < lines.size(); ++i)
    out.joint_receptance.push_back(joint_receptance(lines.blocks(i)).value_or(Eigen::MatrixXcd()));
}

void require_values(const LineScene& scene, const WayResult& result) {
  if (std::ranges::any_of(result.lines, [](const auto& line) { return line.has_value(); })) return;
  ident::fail(scene.scene, "[joint] way", "the data lack FRFs that way \"" + name(result.way) + "\" needs",
              "use way = \"likelihood\"");
}

/// χ² of a symmetric Z by Lines::falls(); NaN where a line has none.
FreeFit by_falls(const std::vector<double>& falls, std::size_t elements, const WayResult& fitted) {
  FreeFit out;
  for (std::size_t i = 0; i < falls.size(); ++i) {
    const auto& line = fitted.lines[i];
    if (!line || !std::isfinite(line->chi_square)) continue;
    out.chi_square += line->chi_square - falls[i];
    out.freedom += std::max(0.0, line->freedom - 2.0 * static_cast<double>(elements - fitted.basis.size()));
  }
  return out;
}

IdentifiedLines identify(const LineScene& scene, const ident::Plan& plan, const ident::Control& control) {
  Lines lines(scene, plan, control);
  IdentifiedLines out;
  out.dofs = scene.scene.joints.front().dofs;
  for (const ident::Line& line : plan.lines) out.frequency_hz.push_back(line.frequency_hz);
  add_conditions(lines, out);
  out.likelihood = empty_result(Way::likelihood, scene);
  const LineScene whole = with_structure(scene, Structure::symmetric);
  const restrictions::Restriction wider = restrictions::build({whole.scene.joints.front()});
  std::tie(out.restarted, out.failed) =
      lines.run_likelihood(plan.restriction, out.likelihood, scene.structure == Structure::symmetric ? nullptr : &wider);
  for (const Way way : scene.ways) {
    if (way == Way::likelihood) {
      out.ways.push_back(out.likelihood);
      continue;
    }
    out.ways.push_back(empty_result(way, scene));
    lines.run_closed_form(out.ways.back());
    require_values(scene, out.ways.back());
    if (way == Way::dual) add_receptances(lines, out);
  }
  const auto free_fit = [&](FreeFit::Kind kind) {
    const std::size_t elements = wider.unknowns.size() / 2;
    const ident::LineData& first = ident::likelihood_plan(plan)->observations->lines().front();
    const ident::LineLayout& layout = ident::likelihood_plan(plan)->observations->layout();
    if (first.redundancy(layout) <= 2.0 * static_cast<double>(elements)) return FreeFit{};
    if (kind == FreeFit::Kind::first_order) return by_falls(lines.falls(), elements, out.likelihood);
    WayResult result = empty_result(Way::likelihood, whole);
    constexpr double enough = 0.03;  // for χ²
    lines.go_on_from(out.likelihood, enough);
    lines.run_likelihood(wider, result);
    return total_of(result.lines);
  };
  judge_lines(plan, scene, free_fit, out);
  add_laws(scene, out);
  add_smooth(scene, out);
  for (const std::string& warning : plan.warnings) out.notes.push_back(warning);
  return out;
}

void refuse_systematic(const LineScene& scene) {
  if (!ident::are_errors_unknown(scene.scene.data)) return;
  ident::fail(scene.scene, "[data]", "gains and masses that are not known exactly do not go with [joint] lines",
              "give masses as exact in [data.files], and remove [[data.gains]]");
}

}  // namespace

std::vector<ElementName> elements_of(const LineScene& scene) { return empty_result(Way::likelihood, scene).elements; }

IdentifiedLines identify_lines(const LineScene& scene, const ident::Control& control) {
  refuse_systematic(scene);
  return identify(scene, *ident::make_plan(scene.scene), control);
}

IdentifiedLines identify_lines(const LineScene& scene, std::vector<frf::FrfSet> substructures, std::vector<frf::FrfSet> assembly,
                               const ident::Control& control) {
  refuse_systematic(scene);
  return identify(scene, *ident::make_plan(scene.scene, std::move(substructures), std::move(assembly)), control);
}

}  // namespace jointid::impedance
