#include "ident/likelihood/data/scaled_line.hpp"

#include <algorithm>
#include <cmath>

namespace jointid::ident {
namespace {

/// FRFs of one part on a line.
struct PartOfLine {
  std::shared_ptr<ScaledPart> frfs;
  std::vector<ScaleUnknown> scales;  ///< those of the line's frequency
  std::vector<double> deviation;     ///< of each
  /// Of each FRF: its element, the variance that it has of it, and its place in the part.
  struct Frf {
    std::size_t element;
    double share;
    std::size_t row, column;
  };
  std::vector<Frf> elements;
};

/// A scale that a step of the fit asks for: from e⁻¹ to e. Steps that go beyond are refused by their cost, and must be possible
/// to try.
double within_reach(double logarithm) { return std::isfinite(logarithm) ? std::clamp(logarithm, -1.0, 1.0) : 0.0; }

class ScaledLine final : public ScaledFrfs {
 public:
  ScaledLine(double frequency_hz, std::vector<PartOfLine> parts) : frequency_hz_(frequency_hz), parts_(std::move(parts)) {
    for (const PartOfLine& part : parts_) described_.push_back(part.frfs->at(frequency_hz_, 0.0, 0.0).h);
  }

  std::vector<Change> at(std::span<const double> phi) const override {
    std::vector<Change> out;
    for (std::size_t p = 0; p < parts_.size(); ++p) add(parts_[p], described_[p], phi, out);
    std::ranges::stable_sort(out, {}, &Change::element);
    return out;
  }

 private:
  void add(const PartOfLine& part, const Eigen::MatrixXcd& described, std::span<const double> phi,
           std::vector<Change>& out) const {
    double stiffness = 0.0, mass = 0.0;
    for (std::size_t s = 0; s < part.scales.size(); ++s) {
      const double z = phi.empty() ? 0.0 : part.deviation[s] * phi[part.scales[s].unknown];
      (part.scales[s].is_mass ? mass : stiffness) += z;
    }
    const ScaledPart::Values now = part.frfs->at(frequency_hz_, within_reach(stiffness), within_reach(mass));
    for (const PartOfLine::Frf& frf : part.elements) {
      const auto r = static_cast<Eigen::Index>(frf.row), c = static_cast<Eigen::Index>(frf.column);
      Change change{.element = frf.element, .value = now.h(r, c) - described(r, c), .share = frf.share};
      const double before = std::abs(described(r, c));
      if (before > 0.0) change.size = std::abs(now.h(r, c)) / before;
      for (std::size_t s = 0; s < part.scales.size(); ++s) {
        const Eigen::MatrixXcd& by = part.scales[s].is_mass ? now.by_mass : now.by_stiffness;
        change.rates.emplace_back(part.scales[s].unknown, part.deviation[s] * by(r, c));
      }
      out.push_back(std::move(change));
    }
  }

  double frequency_hz_;
  std::vector<PartOfLine> parts_;
  std::vector<Eigen::MatrixXcd> described_;
};

double both_parts(Complex variance) { return variance.real() + variance.imag(); }

}  // namespace

ScaledParts::ScaledParts(const Scene& scene, const SystematicPlan& plan, const frf::FrfSystem& substructures,
                         const Dofs& coordinates)
    : unknowns_(plan.unknowns()) {
  for (std::size_t file = 0; file < substructures.source_count(); ++file) {
    if (plan.scales(file).empty()) continue;
    Part part{.file = scene.data.substructures[file], .place = {}, .coordinates = {}, .scales = plan.scales(file)};
    for (const frf::Dof& dof : coordinates) {
      const bool is_own = substructures.source_of(dof) == file;
      part.place.push_back(is_own ? part.coordinates.size() : frf::npos);
      if (is_own) part.coordinates.push_back(dof);
    }
    if (!part.coordinates.empty()) parts_.push_back(std::move(part));
  }
}

void ScaledParts::open(double low_hz, double high_hz) {
  constexpr double reach = 4.0;  // standard deviations
  for (Part& part : parts_) {
    if (part.frfs && low_hz >= part.low_hz && high_hz <= part.high_hz) continue;
    part.low_hz = low_hz;
    part.high_hz = high_hz;
    double stiffness = 0.0, mass = 0.0;
    for (const ScaleUnknown& scale : part.scales) {
      double& largest = scale.is_mass ? mass : stiffness;
      largest = std::max(largest, unknowns_[scale.unknown].deviation);
    }
    const double factor = std::exp(0.5 * reach * std::hypot(stiffness, mass));
    part.frfs = std::make_shared<ScaledPart>(part.file, part.coordinates, ScaledPart::Range{low_hz / factor, high_hz * factor});
  }
}

std::shared_ptr<const ScaledFrfs> ScaledParts::line(double frequency_hz, const LineLayout& layout,
                                                    const BothMeasured& measured) const {
  std::vector<PartOfLine> parts;
  for (const Part& each : parts_) {
    PartOfLine part{.frfs = each.frfs, .scales = {}, .deviation = {}, .elements = {}};
    for (const ScaleUnknown& scale : each.scales) {
      if (!scale.band.has(frequency_hz)) continue;
      part.scales.push_back(scale);
      part.deviation.push_back(unknowns_[scale.unknown].deviation);
    }
    if (part.scales.empty()) continue;
    std::size_t element = 0;
    for_each_element(layout, [&](ElementOf of, Element at) {
      const std::size_t row = each.place[at.row], column = each.place[at.column], own = element++;
      if (of == ElementOf::assembly || row == frf::npos || column == frf::npos) return;
      const Measured& sub = measured.substructures.at(at.row, at.column);
      double share = 1.0;
      if (of == ElementOf::difference) {
        const Measured& whole = measured.assembly.at(at.row, at.column);
        if (!sub.known() || !whole.known()) return;
        const double ours = both_parts(sub.variance), all = ours + both_parts(whole.variance);
        share = all > 0.0 ? ours / all : 0.5;
      } else if (!sub.known()) {
        return;
      }
      part.elements.push_back({own, share, row, column});
    });
    if (!part.elements.empty()) parts.push_back(std::move(part));
  }
  if (parts.empty()) return nullptr;
  return std::make_shared<ScaledLine>(frequency_hz, std::move(parts));
}

}  // namespace jointid::ident
