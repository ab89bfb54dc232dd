#pragma once

#include <functional>

namespace jointid::bench {

/// How far the peak of this process's memory is above what was in use before `work`, in MB.
double growth_megabytes(const std::function<void()>& work);

}  // namespace jointid::bench
