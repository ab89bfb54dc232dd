#include "problems/planted.hpp"

#include <algorithm>
#include <cmath>

#include "base/complex.hpp"
#include "frf/noise/noise.hpp"
#include "problems/case/catalogue.hpp"
#include "problems/structure/spring_coupling.hpp"

namespace jointid::problems {
namespace {

using ident::SuspectKind;
using Complex = Complex;

double radians(const frf::FrfSet& set, std::size_t value) {
  return angular(set.header.frequency_hz[value / set.header.entries()]);
}

template <class Change>
void change_each(frf::FrfSet& set, Change change) {
  for (std::size_t i = 0; i < set.values.size(); ++i) set.values[i] = change(set.values[i], radians(set, i));
}

template <class Change>
void change_row(frf::FrfSet& set, std::size_t row, Change change) {
  for (std::size_t l = 0; l < set.header.lines(); ++l) {
    for (std::size_t c = 0; c < set.header.reference.size(); ++c) change(l, set.values[set.index(l, row, c)], c);
  }
}

/// Part of a set: the same values at fewer coordinates.
frf::FrfSet restricted(const frf::FrfSet& whole, const frf::FrfSet& like) {
  frf::FrfSet result = like;
  for (std::size_t l = 0; l < like.header.lines(); ++l) {
    for (std::size_t r = 0; r < like.header.response.size(); ++r) {
      for (std::size_t c = 0; c < like.header.reference.size(); ++c) {
        const std::size_t from_r = frf::find_coordinate(whole.header.response, like.header.response[r]);
        const std::size_t from_c = frf::find_coordinate(whole.header.reference, like.header.reference[c]);
        result.values[like.index(l, r, c)] = whole.values[whole.index(l, from_r, from_c)];
      }
    }
  }
  return result;
}

/// The assembly at 1/`stretch` of its frequencies, under its own labels.
frf::FrfSet stretched(const Problem& problem, double stretch) {
  for (Case& definition : all_cases()) {
    if (definition.name != problem.name) continue;
    definition.axis.start_hz /= stretch;
    definition.axis.step_hz /= stretch;
    frf::FrfSet result = problem.assembly;
    result.values = build(definition).assembly.values;
    return result;
  }
  return problem.assembly;
}

/// H_rc/(1 − ω²m H_rr) at translations r that are references too.
frf::FrfSet with_roving_mass(const frf::FrfSet& set, double mass) {
  frf::FrfSet result = set;
  for (std::size_t r = 0; r < set.header.response.size(); ++r) {
    const std::size_t point = frf::find_coordinate(set.header.reference, set.header.response[r]);
    if (point == frf::npos || set.header.response[r].is_rotation()) continue;
    change_row(result, r, [&](std::size_t l, Complex& value, std::size_t) {
      const double omega = angular(set.header.frequency_hz[l]);
      value /= 1.0 - omega * omega * mass * set.values[set.index(l, r, point)];
    });
  }
  return result;
}

/// What the structures were when the mistake was made before the noise.
Measurement clean_data(const Problem& problem, SuspectKind kind) {
  Measurement clean{problem.substructures, problem.assembly};
  if (kind == SuspectKind::axis) clean.assembly = stretched(problem, 1.01);
  if (kind == SuspectKind::mass)
    clean.assembly = with_roving_mass(problem.assembly, problem.name.starts_with("bolts") ? 0.02 : 0.003);
  if (kind == SuspectKind::loose)
    clean.assembly.values = restricted(side_by_side(problem.substructures), problem.assembly).values;
  return clean;
}

bool alike(const frf::FrfSet& a, const frf::FrfSet& b) {
  return a.header.response.size() == b.header.response.size() && a.header.reference.size() == b.header.reference.size();
}

/// Draws by the seed.
class Planter {
 public:
  Planter(const Problem& problem, SuspectKind kind, const frf::NoiseModel& noise, std::uint64_t seed)
      : even_(seed % 2 == 0), random_(seed * 7919 + 17) {
    const Measurement clean = clean_data(problem, kind);
    for (std::size_t i = 0; i < clean.substructures.size(); ++i) {
      planted_.data.substructures.push_back(frf::polluted(clean.substructures[i], noise, seed, 0, i));
    }
    planted_.data.assembly = frf::polluted(clean.assembly, noise, seed, 0, clean.substructures.size());
    planted_.kind = kind;
  }

  Planted plant() {
    switch (planted_.kind) {
      case SuspectKind::sign:
        sign();
        break;
      case SuspectKind::swap:
        swap();
        break;
      case SuspectKind::label:
        label();
        break;
      case SuspectKind::gain:
        gain();
        break;
      case SuspectKind::unit:
        unit();
        break;
      case SuspectKind::quantity:
        quantity();
        break;
      case SuspectKind::conjugate:
        conjugate();
        break;
      case SuspectKind::delay:
        change_each(accuse_assembly(), [](Complex h, double w) { return h * std::polar(1.0, -20e-6 * w); });
        break;
      case SuspectKind::dead:
        change_row(accuse_assembly(), draw_row(), [](std::size_t, Complex& h, std::size_t) { h = 0.0; });
        break;
      case SuspectKind::copy:
        copy();
        break;
      case SuspectKind::exchange:
        exchange();
        break;
      default:
        accuse_assembly();
        break;  // made before the noise
    }
    return std::move(planted_);
  }

 private:
  frf::FrfSet& accuse(frf::FrfSet& set) {
    planted_.files = {set.header.file};
    return set;
  }
  frf::FrfSet& accuse_assembly() { return accuse(planted_.data.assembly); }
  std::size_t draw(std::size_t count) {
    random_ = random_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<std::size_t>((random_ >> 33) % count);
  }
  /// A row of the assembly, which is accused.
  std::size_t draw_row() {
    const auto& response = planted_.data.assembly.header.response;
    const std::size_t row = draw(response.size());
    planted_.dofs.push_back(response[row]);
    return row;
  }
  std::size_t other_row(std::size_t row) {
    const auto& response = planted_.data.assembly.header.response;
    std::size_t other = row;
    while (other == row || response[other].is_rotation() != response[row].is_rotation()) other = draw(response.size());
    planted_.dofs.push_back(response[other]);
    return other;
  }

  void sign() {
    const std::size_t at = draw(planted_.data.substructures.size() + 1);
    frf::FrfSet& set = accuse(at == 0 ? planted_.data.assembly : planted_.data.substructures[at - 1]);
    const std::size_t row = draw(set.header.response.size());
    planted_.dofs = {set.header.response[row]};
    change_row(set, row, [](std::size_t, Complex& h, std::size_t) { h = -h; });
  }
  void swap() {
    frf::FrfSet& set = accuse_assembly();
    const std::size_t a = draw_row(), b = other_row(a);
    change_row(set, a, [&](std::size_t l, Complex& h, std::size_t c) { std::swap(h, set.values[set.index(l, b, c)]); });
  }
  void label() {
    frf::FrfSet& set = accuse_assembly();
    set.header.response[draw_row()].node = 9999;
    planted_.dofs.front().node = 9999;
  }
  void gain() {
    change_row(accuse_assembly(), draw_row(), [](std::size_t, Complex& h, std::size_t) { h *= 1.02; });
  }
  void unit() {
    frf::FrfSet& set = accuse(even_ ? planted_.data.assembly : planted_.data.substructures.front());
    change_each(set, [&](Complex h, double) { return even_ ? h / 9.80665 : h * 1e3; });
  }
  void quantity() {
    frf::FrfSet& set = accuse(even_ ? planted_.data.assembly : planted_.data.substructures.front());
    const bool accelerance = set.header.quantity == frf::Quantity::accelerance;
    change_each(set, [&](Complex h, double w) { return accelerance ? h / Complex(0.0, w) : h * Complex(0.0, w); });
  }
  void conjugate() {
    const auto conjugated = [](Complex h, double) { return std::conj(h); };
    change_each(accuse_assembly(), conjugated);
    if (!even_) return;
    for (frf::FrfSet& set : planted_.data.substructures) {
      change_each(set, conjugated);
      planted_.files.push_back(set.header.file);
    }
  }
  void copy() {
    frf::FrfSet& set = accuse_assembly();
    const std::size_t a = draw_row(), b = other_row(a);
    change_row(set, a, [&](std::size_t l, Complex& h, std::size_t c) { h = set.values[set.index(l, b, c)]; });
  }
  void exchange() {
    std::vector<frf::FrfSet>& parts = planted_.data.substructures;
    if (parts.size() > 1 && alike(parts[0], parts[1])) {
      planted_.files = {parts[0].header.file, parts[1].header.file};
      std::swap(parts[0].values, parts[1].values);
      std::swap(parts[0].coherence, parts[1].coherence);
    } else {
      accuse(parts.front()).values = restricted(planted_.data.assembly, parts.front()).values;
    }
  }

  Planted planted_;
  bool even_;
  std::uint64_t random_;
};

}  // namespace

const std::vector<SuspectKind>& plantable() {
  static const std::vector<SuspectKind> kinds = {
      SuspectKind::sign,     SuspectKind::swap,      SuspectKind::label, SuspectKind::gain,    SuspectKind::unit,
      SuspectKind::quantity, SuspectKind::conjugate, SuspectKind::delay, SuspectKind::axis,    SuspectKind::mass,
      SuspectKind::dead,     SuspectKind::copy,      SuspectKind::loose, SuspectKind::exchange};
  return kinds;
}

Planted plant(const Problem& problem, SuspectKind kind, const frf::NoiseModel& noise, std::uint64_t seed) {
  return Planter(problem, kind, noise, seed).plant();
}

bool is_found(const Planted& planted, const std::vector<ident::Suspect>& suspects) {
  if (suspects.empty()) return false;
  const ident::Suspect& first = suspects.front();
  const bool dofs =
      std::ranges::all_of(planted.dofs, [&](const frf::Dof& dof) { return frf::has(first.dofs, dof); });
  return first.kind == planted.kind && dofs && std::ranges::find(planted.files, first.file) != planted.files.end();
}

}  // namespace jointid::problems
