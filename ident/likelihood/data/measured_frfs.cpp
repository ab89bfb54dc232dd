#include "ident/likelihood/data/measured_frfs.hpp"

#include "base/statistics.hpp"

namespace jointid::ident {
namespace {

bool is_exactly_zero(const Measured& m) { return m.value == Complex(0.0) && m.variance == Complex(0.0) && !m.averaged; }

}  // namespace

void MeasuredFrfs::pack(std::size_t size, const MeasuredFrfs* before) {
  constexpr std::uint32_t nothing = 0, zero = 1;
  const Complex none(nan, nan);
  Places places;
  places.reserve(triangle_size(size));
  kept_ = {{none, none}, {0.0, 0.0}};
  for (std::size_t row = 0; row < size; ++row) {
    for (std::size_t column = 0; column <= row; ++column) {
      const Measured& m = all_.at(row, column);
      const bool is_kept = m.known() && !is_exactly_zero(m);
      places.push_back(is_kept ? static_cast<std::uint32_t>(kept_.size()) : m.known() ? zero : nothing);
      if (is_kept) kept_.push_back(m);
    }
  }
  kept_.shrink_to_fit();
  all_ = Symmetric<Measured>(0);
  const bool is_like = before != nullptr && before->places_ && *before->places_ == places;
  places_ = is_like ? before->places_ : std::make_shared<const Places>(std::move(places));
}

std::size_t MeasuredFrfs::bytes() const { return kept_.capacity() * sizeof(Measured); }

}  // namespace jointid::ident
