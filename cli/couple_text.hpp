#pragma once

#include <string>

#include "ident/couple.hpp"

namespace jointid::cli {

/// What coupling did, for people.
std::string couple_text(const ident::CoupleScene& scene, const ident::CoupleResult& result);

/// Line by line: frequency_hz, condition, kept, usable, and the alpha of each condition of method mtc.
std::string couple_csv(const ident::CoupleResult& result);

/// "mtc, threshold alpha 0.3".
std::string coupling_method_text(const ident::CoupleScene& scene);

/// How many lines kept how many singular values (conditions), most first.
std::vector<std::pair<std::size_t, std::size_t>> kept_counts(const ident::CoupleResult& result);

/// Index of the line with the largest condition number, or npos.
std::size_t worst_line(const ident::CoupleResult& result);

}  // namespace jointid::cli
