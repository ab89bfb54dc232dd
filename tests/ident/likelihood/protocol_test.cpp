#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "ident/likelihood/fit/estimator.hpp"

namespace jointid::ident {
namespace {

template <class Of>
concept FitsAsItIs = requires(Of& of, const FitWatcher& watch) { of.refine(std::vector<double>(), watch); };
template <class Of>
concept FitsOnce = requires(Of of, const FitWatcher& watch) { std::move(of).refine(std::vector<double>(), watch); };
template <class Of>
concept IsConstrainedOnce = requires(Of of, const AdmissibleSet& set, const FitWatcher& watch) { std::move(of).constrained(set, watch); };
template <class Of>
concept IsConstrainedAsItIs = requires(Of& of, const AdmissibleSet& set, const FitWatcher& watch) { of.constrained(set, watch); };
template <class Of>
concept TellsLines = requires(const Of& of) { of.line_at(0), of.state_of(0), of.information_of(0); };
template <class Of>
concept TellsErrors = requires(Of& of) { of.godambe_information(); };
template <class Of>
concept RanksStarts = requires(Of& of) { of.misfit_at(std::vector<double>()); };

/// The order of calls is in the types: what cannot be called does not exist yet, or no more.
TEST(LikelihoodProtocol, StartsComeBeforeFitsAndWhatIsSaidOfThemAfter) {
  EXPECT_TRUE(FitsOnce<LikelihoodEstimator> && RanksStarts<LikelihoodEstimator>);
  EXPECT_FALSE(FitsAsItIs<LikelihoodEstimator>);
  EXPECT_FALSE(TellsLines<LikelihoodEstimator> || TellsErrors<LikelihoodEstimator> || IsConstrainedOnce<LikelihoodEstimator>);
  EXPECT_TRUE(TellsLines<LinearisedLikelihood> && TellsErrors<LinearisedLikelihood> && IsConstrainedOnce<LinearisedLikelihood>);
  EXPECT_FALSE(IsConstrainedAsItIs<LinearisedLikelihood>);
  EXPECT_FALSE(FitsOnce<LinearisedLikelihood> || RanksStarts<LinearisedLikelihood>);
}

}  // namespace
}  // namespace jointid::ident
