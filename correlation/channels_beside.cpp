#include "correlation/channels_beside.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/error.hpp"
#include "base/statistics.hpp"
#include "correlation/criteria.hpp"

namespace jointid::correlation {
namespace {

using ShapeColumn = std::vector<Complex>;

/// A coordinate that both sets have, and the sign between its DOFs.
struct CommonDof {
  std::size_t measured = 0, model = 0;
  double sign = 1.0;
};

std::vector<CommonDof> pairs_of_dofs(const std::vector<frf::Dof>& measured, const std::vector<frf::Dof>& model) {
  std::vector<CommonDof> out;
  for (std::size_t k = 0; k < measured.size(); ++k) {
    const std::size_t at = frf::find_coordinate(model, measured[k]);
    if (at != frf::npos) out.push_back({k, at, static_cast<double>(measured[k].sign * model[at].sign)});
  }
  return out;
}

/// Sums over lines of a measured response and a coordinate of the model in the matching shapes.
struct ShapeSums {
  Complex cross{};  ///< conj(model) · measured
  double model = 0.0, measured = 0.0;

  void add(Complex of_model, Complex of_measured) {
    cross += std::conj(of_model) * of_measured;
    model += std::norm(of_model);
    measured += std::norm(of_measured);
  }
  double agreement() const { return model > 0.0 && measured > 0.0 ? std::norm(cross) / (model * measured) : 0.0; }
  double factor() const { return model > 0.0 ? cross.real() / model : 0.0; }
};

/// A measured column over the common responses and the model's that is most like it.
struct ShapeMatch {
  std::size_t line = 0, model_line = 0;
  Complex scale{};    ///< measured ≈ scale · model
  double unit = 0.0;  ///< 1 / |scale · model|
};

class Comparison {
 public:
  Comparison(const frf::FrfSet& measured, const frf::FrfSet& model, double shift)
      : measured_(measured),
        model_(model),
        shift_(shift),
        responses_(pairs_of_dofs(measured.header.response, model.header.response)),
        references_(pairs_of_dofs(measured.header.reference, model.header.reference)) {
    if (responses_.size() < 3 || references_.empty()) {
      throw InputError({ErrorKind::data, measured.header.file, "responses",
                        "the model has " + std::to_string(responses_.size()) + " of its responses and " +
                            std::to_string(references_.size()) + " of its references",
                        "a shape takes three responses and a reference that both have: give the model's dofs the names of the test"});
    }
  }

  SetBeside run() {
    for (const CommonDof& reference : references_) matches_.push_back(matches_of(reference));
    SetBeside out;
    add_responses(out);
    add_references(out);
    add_whole(out);
    return out;
  }

 private:
  Complex measured_at(std::size_t line, const CommonDof& response, const CommonDof& reference) const {
    return response.sign * reference.sign * measured_.values[measured_.index(line, response.measured, reference.measured)];
  }
  Complex model_at(std::size_t line, std::size_t response, const CommonDof& reference) const {
    return model_.values[model_.index(line, response, reference.model)];
  }

  /// Scale of two columns: least squares, then again without what does not fit, so that a channel that is wrong does not count.
  static Complex scale_of(const ShapeColumn& model, const ShapeColumn& measured) {
    std::vector<double> weight(model.size(), 1.0);
    Complex scale{};
    for (int round = 0; round < 6; ++round) {
      Complex cross{};
      double norm = 0.0;
      for (std::size_t k = 0; k < model.size(); ++k) {
        cross += weight[k] * std::conj(model[k]) * measured[k];
        norm += weight[k] * std::norm(model[k]);
      }
      if (!(norm > 0.0)) return {};
      scale = cross / norm;
      std::vector<double> off;
      for (std::size_t k = 0; k < model.size(); ++k) off.push_back(std::abs(measured[k] - scale * model[k]));
      const double usual = median(off);
      for (std::size_t k = 0; k < model.size(); ++k) weight[k] = 1.0 / std::max(off[k], 0.1 * usual + 1e-300);
    }
    return scale;
  }

  std::vector<ShapeMatch> matches_of(const CommonDof& reference) const {
    std::vector<ShapeMatch> out;
    const std::vector<double>&hz = measured_.header.frequency_hz, &of_model = model_.header.frequency_hz;
    for (std::size_t line = 0; line < hz.size(); ++line) {
      ShapeColumn measured;
      for (const CommonDof& response : responses_) measured.push_back(measured_at(line, response, reference));
      if (!std::ranges::all_of(measured, is_number)) continue;
      ShapeMatch best;
      double most = -1.0;
      ShapeColumn best_column;
      for (std::size_t k = 0; k < of_model.size(); ++k) {
        if (std::abs(of_model[k] - hz[line]) > shift_ * hz[line]) continue;
        ShapeColumn column;
        for (const CommonDof& response : responses_) column.push_back(model_at(k, response.model, reference));
        const double alike = frac(column, measured);
        if (!(alike > most)) continue;
        most = alike;
        best = {line, k, {}, 0.0};
        best_column = std::move(column);
      }
      if (most < 0.0) continue;
      best.scale = scale_of(best_column, measured);
      double norm = 0.0;
      for (const Complex each : best_column) norm += std::norm(best.scale * each);
      best.unit = 1.0 / std::sqrt(norm);
      if (norm > 0.0) out.push_back(best);
    }
    return out;
  }

  /// Of a measured response, with the sign of the model's DOF of its own, and a coordinate of the model; every line with the same weight.
  ShapeSums sums_of(const CommonDof& response, std::size_t of_model) const {
    ShapeSums out;
    for (std::size_t c = 0; c < references_.size(); ++c) {
      for (const ShapeMatch& match : matches_[c]) {
        out.add(match.unit * match.scale * model_at(match.model_line, of_model, references_[c]),
                match.unit * measured_at(match.line, response, references_[c]));
      }
    }
    return out;
  }

  void add_responses(SetBeside& out) const {
    constexpr double little = 0.7;
    std::vector<double> agreements;
    for (const CommonDof& response : responses_) {
      const ShapeSums own = sums_of(response, response.model);
      ChannelBeside channel{.dof = measured_.header.response[response.measured],
                            .factor = own.factor(),
                            .agreement = own.agreement(),
                            .alike = std::nullopt};
      agreements.push_back(channel.agreement);
      if (channel.agreement < little) find_alike(response, channel);
      out.channels.push_back(channel);
    }
    out.agreement = median(agreements);
  }

  void find_alike(const CommonDof& response, ChannelBeside& channel) const {
    for (std::size_t k = 0; k < model_.header.response.size(); ++k) {
      if (k == response.model) continue;
      const ShapeSums other = sums_of(response, k);
      if (!(other.agreement() > channel.agreement_alike)) continue;
      channel.agreement_alike = other.agreement();
      channel.alike = model_.header.response[k];
      // Of the response without that sign: the DOF that the sensor was along.
      if (other.factor() * response.sign < 0.0) channel.alike->sign = -channel.alike->sign;
    }
  }

  void add_references(SetBeside& out) const {
    for (std::size_t c = 0; c < references_.size(); ++c) {
      std::vector<double> sizes;
      double with = 0.0, all = 0.0;
      for (const ShapeMatch& match : matches_[c]) {
        sizes.push_back(std::abs(match.scale));
        const double share = match.scale.real() / std::abs(match.scale);
        with += share;
        all += std::abs(share);
      }
      if (sizes.empty()) continue;
      const double mean = all > 0.0 ? with / all : 0.0;
      out.channels.push_back({.dof = measured_.header.reference[references_[c].measured],
                              .is_reference = true,
                              .factor = std::copysign(median(sizes), mean),
                              .agreement = std::abs(mean),
                              .alike = std::nullopt});
    }
  }

  void add_whole(SetBeside& out) const {
    std::vector<double> sizes, ratios, log_omega, log_size;
    for (const std::vector<ShapeMatch>& of_reference : matches_) {
      for (const ShapeMatch& match : of_reference) {
        const double hz = measured_.header.frequency_hz[match.line];
        sizes.push_back(std::abs(match.scale));
        ratios.push_back(model_.header.frequency_hz[match.model_line] / hz);
        log_omega.push_back(std::log(hz));
        log_size.push_back(std::log(std::abs(match.scale)));
      }
    }
    if (sizes.empty()) return;
    out.factor = median(sizes);
    out.frequency_ratio = median(ratios);
    out.slope = median_slope(log_omega, log_size);
  }

  /// The median of the slopes between a point and its counterpart half of all further on.
  static double median_slope(const std::vector<double>& x, const std::vector<double>& y) {
    std::vector<std::size_t> order(x.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return x[i]; });
    const std::size_t half = x.size() / 2;
    std::vector<double> slopes;
    for (std::size_t i = 0; i + half < order.size(); ++i) {
      const std::size_t a = order[i], b = order[i + half];
      if (x[b] > x[a]) slopes.push_back((y[b] - y[a]) / (x[b] - x[a]));
    }
    return slopes.empty() ? 0.0 : median(slopes);
  }

  const frf::FrfSet &measured_, &model_;
  double shift_;
  std::vector<CommonDof> responses_, references_;
  std::vector<std::vector<ShapeMatch>> matches_;  ///< [reference]
};

}  // namespace

SetBeside beside_model(const frf::FrfSet& measured, const frf::FrfSet& model, double shift) {
  frf::validate(measured);
  frf::validate(model);
  return Comparison(measured, model, shift).run();
}

}  // namespace jointid::correlation
