#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "frf/mat/mat_variable.hpp"

struct matvar_t;

namespace jointid::frf::mat {

/// A sparse matrix NAME as the arrays NAME.data, NAME.ir, NAME.jc and NAME.shape. `dims` of the first two are of those that the file has
/// room for, which may be more than it holds.
std::vector<MatInfo> sparse_infos(const matvar_t& variable, const std::string& name);

/// The numbers of one of them, by its name behind the last dot. Empty where the file holds fewer than it declares.
std::vector<Complex> sparse_numbers(const matvar_t& variable, std::string_view part);

}  // namespace jointid::frf::mat
