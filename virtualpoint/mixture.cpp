#include "virtualpoint/mixture.hpp"

#include <algorithm>
#include <numeric>

#include "base/eigen.hpp"

namespace jointid::virtualpoint {
namespace {

/// Throws InputError (data) where a channel is taken by a point before.
void take(std::vector<bool>& taken, const frf::FrfHeader& header, const VirtualPoint& point, const Transformation& of) {
  for (std::size_t i = 0; i < of.channels.size(); ++i) {
    if (taken[of.channels[i]])
      fail(header, name(point), of.dofs[i].name() + " is in it twice, or in another virtual point", "name it once");
    taken[of.channels[i]] = true;
  }
}

}  // namespace

Mixture mixture(const frf::FrfHeader& header, Side side, const std::vector<VirtualPoint>& points) {
  const std::vector<frf::Dof>& measured = side == Side::sensors ? header.response : header.reference;
  std::vector<bool> taken(measured.size(), false);
  Mixture of_points;
  for (const VirtualPoint& point : points) {
    const Transformation of = transformation(point, side, header);
    if (!of.any()) continue;
    take(taken, header, point, of);
    const std::vector<frf::Dof> names = dofs(point);
    for (std::size_t m = 0; m < names.size(); ++m) {
      if (frf::has(measured, names[m]) || frf::has(of_points.dofs, names[m])) {
        fail(header, name(point), names[m].name() + " is there already",
             "give the virtual point another name, VP" + std::to_string(point.number + 1) + " for instance");
      }
      std::vector<Share> shares;
      for (std::size_t i = 0; i < of.channels.size(); ++i) shares.push_back({of.channels[i], of.to_virtual(at(m), at(i))});
      of_points.dofs.push_back(names[m]);
      of_points.shares.push_back(std::move(shares));
    }
  }
  Mixture out;
  for (std::size_t i = 0; i < measured.size(); ++i) {
    if (taken[i]) continue;
    out.dofs.push_back(measured[i]);
    out.shares.push_back({{i, 1.0}});
  }
  out.dofs.insert(out.dofs.end(), of_points.dofs.begin(), of_points.dofs.end());
  out.shares.insert(out.shares.end(), of_points.shares.begin(), of_points.shares.end());
  return out;
}

std::vector<std::size_t> first_indices(std::size_t count) {
  std::vector<std::size_t> out(count);
  std::iota(out.begin(), out.end(), std::size_t{0});
  return out;
}

PickedMixture::PickedMixture(const Mixture& whole, std::span<const std::size_t> wanted) {
  for (const std::size_t i : wanted) {
    for (const Share& share : whole.shares[i]) channels.push_back(share.channel);
  }
  std::ranges::sort(channels);
  channels.erase(std::unique(channels.begin(), channels.end()), channels.end());
  for (const std::size_t i : wanted) {
    std::vector<Share> of = whole.shares[i];
    for (Share& share : of) {
      share.channel = static_cast<std::size_t>(std::ranges::lower_bound(channels, share.channel) - channels.begin());
    }
    shares.push_back(std::move(of));
  }
}

}  // namespace jointid::virtualpoint
