#pragma once

#include "report/response/scene_values.hpp"

namespace jointid::cli {

using jointid::report::read_matrix;
using jointid::report::read_sparse_matrix;
using jointid::report::read_vector;

}  // namespace jointid::cli
