#include "impedance/decouple/decouple.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/eigen.hpp"
#include "base/parallel.hpp"
#include "base/statistics.hpp"
#include "dense/cholesky.hpp"
#include "ident/likelihood/data/symmetric_frfs.hpp"
#include "ident/plan/data_source.hpp"
#include "ident/plan/line_choice.hpp"
#include "ident/scene/scene_failure.hpp"
#include "impedance/line_findings.hpp"

namespace jointid::impedance {
namespace {

using ident::Dofs;

constexpr double not_there = std::numeric_limits<double>::quiet_NaN();

/// DOFs that are a response or reference of the system.
Dofs dofs_of(const frf::FrfSystem& system) {
  Dofs out;
  for (const Dofs* dofs : {&system.responses(), &system.references()}) {
    for (const frf::Dof& dof : *dofs) {
      if (!frf::has(out, dof)) out.push_back(dof);
    }
  }
  return out;
}

/// The FRFs of a system over some DOFs at all lines, one triangle.
class SystemReader {
 public:
  SystemReader(frf::FrfSystem& system, const ident::Scene& scene, Dofs dofs, const std::vector<std::size_t>& lines)
      : dofs_(std::move(dofs)), frfs_(system, scene, dofs_, 0, {.nn = false, .jn = false, .jj = true}) {
    frfs_.prepare(lines);
    frfs_.read(lines);
  }

  const Dofs& dofs() const { return dofs_; }

  MeasuredSystem line(std::size_t i) const {
    const Eigen::Index size = at(dofs_.size());
    MeasuredSystem out;
    out.h = Eigen::MatrixXcd::Constant(size, size, {not_there, not_there});
    std::vector<ident::Measured> measured;
    for (std::size_t r = 0; r < dofs_.size(); ++r) {
      for (std::size_t c = r; c < dofs_.size(); ++c) {
        const ident::Measured one = frfs_.at(i, r, c);
        if (!one.known()) continue;
        out.h(at(r), at(c)) = out.h(at(c), at(r)) = one.value;
        out.frfs.push_back({at(r), at(c)});
        measured.push_back(one);
      }
    }
    set_errors(i, measured, out);
    return out;
  }

 private:
  /// Independent errors first, then those that groups of FRFs have in common: circular, half of the variance in each part.
  void set_errors(std::size_t i, const std::vector<ident::Measured>& measured, MeasuredSystem& out) const {
    const auto errors = frfs_.errors(i);
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> first;  // column of a group, or of an independent error
    std::vector<Eigen::MatrixXcd> factors;
    for (std::size_t g = 0; errors && g < errors->covariance.size(); ++g)
      factors.push_back(dense::semidefinite_cholesky(errors->covariance[g]));
    for (std::size_t e = 0; e < measured.size(); ++e) {
      const auto [row, column] = out.frfs[e];
      const ident::ErrorTerms* terms =
          errors ? &errors->terms.at(static_cast<std::size_t>(row), static_cast<std::size_t>(column)) : nullptr;
      if (terms == nullptr || terms->empty()) {
        out.errors.push_back({{at(e), std::sqrt(measured[e].variance.real())}});
        out.errors.push_back({{at(e), Complex(0.0, std::sqrt(measured[e].variance.imag()))}});
        continue;
      }
      for (const ident::ErrorTerm& term : *terms) {
        const bool alone = term.group == ident::ErrorTerm::independent;
        const Eigen::Index width = alone ? 1 : factors[term.group].cols();
        const auto [place, is_new] = first.try_emplace({term.group, alone ? term.member : 0}, out.errors.size());
        if (is_new) out.errors.resize(out.errors.size() + static_cast<std::size_t>(2 * width));
        for (Eigen::Index k = 0; k < width; ++k) {
          const Complex value = std::sqrt(0.5) * term.factor * (alone ? Complex(1.0) : factors[term.group](at(term.member), k));
          if (value == 0.0) continue;
          out.errors[place->second + static_cast<std::size_t>(2 * k)].emplace_back(at(e), value);
          out.errors[place->second + static_cast<std::size_t>(2 * k + 1)].emplace_back(at(e), Complex(0.0, 1.0) * value);
        }
      }
    }
  }

  Dofs dofs_;
  ident::SymmetricFrfs frfs_;
};

std::vector<Eigen::Index> places_of(const Dofs& some, const Dofs& all) {
  std::vector<Eigen::Index> out;
  for (const frf::Dof& dof : some) out.push_back(at(frf::find_coordinate(all, dof)));
  return out;
}

bool all_known(const Eigen::MatrixXcd& h, const std::vector<Eigen::Index>& rows, const std::vector<Eigen::Index>& columns) {
  return std::ranges::all_of(rows, [&](Eigen::Index r) {
    return std::ranges::all_of(columns, [&](Eigen::Index c) { return std::isfinite(h(r, c).real()); });
  });
}

/// Closed forms over the systems of a scene.
class ClosedForms {
 public:
  ClosedForms(const DecoupleScene& scene, frf::FrfSystem& a, frf::FrfSystem& whole, const std::vector<ident::Line>& lines)
      : scene_(scene), interface_(scene.interface) {
    const Dofs of_a = dofs_of(a), of_whole = dofs_of(whole);
    for (const frf::Dof& dof : of_a) {
      if (!frf::has(interface_, dof) && frf::has(of_whole, dof)) internal_.push_back(dof);
    }
    for (const frf::Dof& dof : of_whole) {
      if (!frf::has(interface_, dof) && !frf::has(of_a, dof)) inner_.push_back(dof);
    }
    std::vector<std::size_t> a_lines, whole_lines;
    for (const ident::Line& line : lines) {
      a_lines.push_back(line.substructures);
      whole_lines.push_back(line.assembly);
    }
    const ident::Scene& own = scene.lines.scene;
    a_ = std::make_unique<SystemReader>(a, own, joined(internal_), a_lines);
    Dofs everything = joined(internal_);
    everything.insert(everything.end(), inner_.begin(), inner_.end());
    whole_ = std::make_unique<SystemReader>(whole, own, std::move(everything), whole_lines);
  }

  DecoupledWay run(DecoupleWay way, std::size_t lines, std::size_t threads) const {
    DecoupledWay out{.way = way, .dofs = joined(inner_), .lines = {}};
    const Dofs wide = joined(internal_);
    const Dofs& v = way == DecoupleWay::standard ? interface_ : wide;
    const Dofs& e = way == DecoupleWay::both ? wide : interface_;
    if (way != DecoupleWay::standard && internal_.empty()) {
      ident::fail(scene_.lines.scene, "[decouple] way",
                  "way \"" + name(way) + "\" needs internal DOFs of A that the assembly has",
                  "use way = \"standard\", or measure some on both");
    }
    const DecoupleAt where{.u = places_of(out.dofs, whole_->dofs()),
                           .v = places_of(v, whole_->dofs()),
                           .e = places_of(e, whole_->dofs()),
                           .v_of_a = places_of(v, a_->dofs()),
                           .e_of_a = places_of(e, a_->dofs()),
                           .kept = way == DecoupleWay::both ? interface_.size() : 0};
    out.lines.resize(lines);
    for_each_index(lines, threads, [&](std::size_t i) {
      const MeasuredSystem whole = whole_->line(i), a = a_->line(i);
      if (!all_known(whole.h, where.u, where.u) || !all_known(whole.h, where.u, where.e) ||
          !all_known(whole.h, where.v, where.u) || !all_known(whole.h, where.v, where.e) ||
          !all_known(a.h, where.v_of_a, where.e_of_a)) {
        return;
      }
      out.lines[i] = impedance::decouple(whole, a, where);
    });
    if (std::ranges::none_of(out.lines, [](const auto& line) { return line.has_value(); })) {
      ident::fail(scene_.lines.scene, "[decouple] way", "no line has all FRFs that way \"" + name(way) + "\" needs",
                  "use way = \"likelihood\", or leave incomplete DOFs out of the files");
    }
    return out;
  }

 private:
  Dofs joined(const Dofs& more) const {
    Dofs out = interface_;
    out.insert(out.end(), more.begin(), more.end());
    return out;
  }

  const DecoupleScene& scene_;
  Dofs interface_, internal_, inner_;  ///< c, a, b
  std::unique_ptr<SystemReader> a_, whole_;
};

DecoupledWay from_likelihood(const IdentifiedLines& lines) {
  DecoupledWay out{.way = DecoupleWay::likelihood, .dofs = lines.dofs, .lines = {}};
  for (const auto& line : lines.likelihood.lines) {
    std::optional<DecoupledLine> y;
    if (line) y = receptance_of(matrix_of(lines.likelihood.basis, line->z), line->covariance);
    out.lines.push_back(y && y->h.allFinite() ? std::move(y) : std::nullopt);
  }
  return out;
}

void tell(Status status, const std::string& sentence, Decoupled& out) {
  if (out.status == Status::ok) out.status = status;
  out.message += (out.message.empty() ? "" : " ") + sentence;
}

/// Errors of FRFs over the FRFs, the median of all at the interface.
double relative_error(const DecoupledWay& way, Eigen::Index size) {
  std::vector<double> all;
  for (const auto& line : way.lines) {
    if (!line) continue;
    for (Eigen::Index r = 0; r < size; ++r) {
      for (Eigen::Index c = 0; c < size; ++c) {
        all.push_back(std::sqrt(line->variance_re(r, c) + line->variance_im(r, c)) / std::abs(line->h(r, c)));
      }
    }
  }
  return median(all);
}

void judge(const DecoupledWay& way, const DecoupledWay& likelihood, Decoupled& out) {
  constexpr double too_large = 0.1, apart = 5.0;
  const Eigen::Index size = likelihood.lines.empty() ? 0 : at(likelihood.dofs.size());
  const double error = relative_error(way, size);
  const std::string which = way.way == DecoupleWay::likelihood ? "The receptance of B" : "Way \"" + name(way.way) + "\"";
  if (error > too_large) {
    tell(Status::doubtful,
         fmt::format("{} has errors of {:.2g} of its FRFs in the median: intervals to first order do not hold there{}.", which,
                     error, way.way == DecoupleWay::likelihood ? "; those of Z do" : ""),
         out);
  }
  if (way.way == DecoupleWay::likelihood) return;
  const auto run = bad_run(way.lines.size(), [&](std::size_t i) {
    if (!way.lines[i] || !likelihood.lines[i]) return false;
    const DecoupledLine& one = *way.lines[i];
    const Eigen::MatrixXd distance = (one.h.topLeftCorner(size, size) - likelihood.lines[i]->h).cwiseAbs2();
    const Eigen::MatrixXd variance = one.variance_re.topLeftCorner(size, size) + one.variance_im.topLeftCorner(size, size);
    return (distance.array() > apart * apart * variance.array()).any();
  });
  if (!run) return;
  tell(Status::doubtful,
       fmt::format(
           "{} is more than five of its standard errors from the likelihood from {:.6g} to {:.6g} Hz. Use way = \"likelihood\".",
           which, out.frequency_hz[run->first], out.frequency_hz[run->second]),
       out);
}

Decoupled finished(const DecoupleScene& scene, frf::FrfSystem& a, frf::FrfSystem& whole, IdentifiedLines lines,
                   const ident::Control& control) {
  Decoupled out;
  out.status = lines.status;
  out.message = lines.message;
  for (const std::string& note : lines.notes) {
    if (!note.starts_with("No substructure has ")) out.notes.push_back(note);  // B's own DOFs
  }
  out.frequency_hz = lines.frequency_hz;
  const DecoupledWay likelihood = from_likelihood(lines);
  std::vector<std::string> notes;
  std::unique_ptr<ClosedForms> forms;
  for (const DecoupleWay way : scene.ways) {
    if (way != DecoupleWay::likelihood && !forms) {
      forms = std::make_unique<ClosedForms>(scene, a, whole, ident::choose_lines(scene.lines.scene, a, whole, notes));
    }
    out.ways.push_back(way == DecoupleWay::likelihood
                           ? likelihood
                           : forms->run(way, out.frequency_hz.size(), threads_or_cores(control.threads)));
  }
  judge(out.ways.front(), likelihood, out);
  out.likelihood = std::move(lines);
  return out;
}

}  // namespace

Decoupled decouple(const DecoupleScene& scene, const ident::Control& control) {
  ident::OpenedScene opened = ident::open_scene(scene.lines.scene);
  const bool reciprocity = scene.lines.scene.data.reciprocity;
  frf::FrfSystem a("substructures", std::move(opened.substructures), frf::Composition::uncoupled, reciprocity);
  frf::FrfSystem whole("assembly", std::move(opened.assembly), frf::Composition::merged, reciprocity);
  return finished(scene, a, whole, identify_lines(scene.lines, control), control);
}

Decoupled decouple(const DecoupleScene& scene, const std::vector<frf::FrfSet>& a, const std::vector<frf::FrfSet>& whole,
                   const ident::Control& control) {
  const bool reciprocity = scene.lines.scene.data.reciprocity;
  const auto of_a = frf::memory_system("substructures", a, frf::Composition::uncoupled, reciprocity);
  const auto of_whole = frf::memory_system("assembly", whole, frf::Composition::merged, reciprocity);
  return finished(scene, *of_a, *of_whole, identify_lines(scene.lines, a, whole, control), control);
}

frf::FrfSet frfs_of(const Decoupled& decoupled, const DecoupledWay& way) {
  frf::FrfSet out;
  out.header.frequency_hz = decoupled.frequency_hz;
  out.header.response = out.header.reference = way.dofs;
  out.header.noise = frf::NoiseRecord::variance;
  const std::size_t n = way.dofs.size(), lines = way.lines.size(), pairs = frf::pair_count(n);
  out.values.assign(lines * n * n, {not_there, not_there});
  out.variance = out.values;
  out.covariance.assign(lines * pairs * n, {not_there, not_there});
  for (std::size_t i = 0; i < lines; ++i) {
    if (!way.lines[i]) continue;
    const DecoupledLine& line = *way.lines[i];
    for (std::size_t c = 0; c < n; ++c) {
      for (std::size_t r = 0; r < n; ++r) {
        out.values[out.index(i, r, c)] = line.h(at(r), at(c));
        out.variance[out.index(i, r, c)] = {line.variance_re(at(r), at(c)), line.variance_im(at(r), at(c))};
        for (std::size_t s = 0; s <= r; ++s) {
          out.covariance[(i * pairs + frf::pair_index(r, s)) * n + c] = line.covariance[c](at(r), at(s));
        }
      }
    }
  }
  return out;
}

}  // namespace jointid::impedance
