#pragma once

#include <cstddef>
#include <vector>

#include "modalfit/band/band.hpp"
#include "modalfit/model/modal_fit.hpp"
#include "modalfit/poles/clusters.hpp"
#include "modalfit/poles/refine.hpp"

namespace jointid::modalfit {

/// The search for the poles of a band by some of its entries. What is merged, left out or left over goes into the fit's remarks and
/// peaks; updates the weights of a band whose noise is not known.
class PoleSearch {
 public:
  PoleSearch(Band& band, const FitOptions& options, const std::vector<std::size_t>& entries)
      : band_(band), options_(options), entries_(entries) {}

  /// Polyreference poles, clusters, significance and refinement until they agree; peaks of the residual FRFs; doubled poles;
  /// poles beyond the range; vague poles. FRFs without noise that the outcome does not follow to their digits are searched once
  /// more, with poles kept apart and split: what follows them is taken, and so are the poles of the
  /// rational function that such FRFs are. Then poles beyond the range are added until such FRFs are
  /// followed to their rounding or no pole lowers what is left.
  RefinedPoles run(ModalFit& out);
  /// Refines poles that were chosen elsewhere, none of which goes.
  RefinedPoles as_given(std::vector<Pole> poles, ModalFit& out);

 private:
  void tell(const char* stage) const {
    if (options_.progress) options_.progress(stage);
  }
  bool stopped() const { return options_.interrupted && options_.interrupted(); }

  RefinedPoles run_usual(ModalFit& out);
  std::vector<Pole> candidates(const ClusterOptions& clusters, ModalFit& out);
  RefinedPoles settled(std::vector<Pole> poles, bool beyond, ModalFit& out);
  bool noise_agrees(const RefinedPoles& refined, double before) const;
  void add_peaks(RefinedPoles& refined, ModalFit& out);
  void merge_doubled(RefinedPoles& refined, ModalFit& out);
  void drop_vague(RefinedPoles& refined, ModalFit& out);
  std::vector<Pole> select(std::vector<Pole> poles, bool beyond) const;
  void extend(RefinedPoles& refined, ModalFit& out);
  bool add(const Pole& pole, RefinedPoles& refined, ModalFit& out);
  std::size_t inside(const RefinedPoles& refined) const;

  bool may_be_exact(const RefinedPoles& refined) const;
  void seek_exact(RefinedPoles& refined, ModalFit& out);
  bool split(RefinedPoles& refined, ModalFit& out);
  double quiet_where(const RefinedPoles& refined) const;
  bool leaves_more_than_rounding(const RefinedPoles& refined) const;
  void follow_rational(RefinedPoles& refined, ModalFit& out);
  void follow_beyond(RefinedPoles& refined, ModalFit& out);
  std::vector<std::size_t> least_agreed(const RefinedPoles& refined) const;

  Band& band_;
  const FitOptions& options_;
  const std::vector<std::size_t>& entries_;
};

}  // namespace jointid::modalfit
