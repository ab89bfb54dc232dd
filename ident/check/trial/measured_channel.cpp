#include "ident/check/trial/measured_channel.hpp"

#include <algorithm>

#include "base/eigen.hpp"

namespace jointid::ident {

const Dofs& dofs_of(const CheckedFile& file, Role role) { return role == Role::response ? file.responses : file.references; }

bool has_role(const CheckedFile& file, Role role, const frf::Dof& dof) { return place_of(dofs_of(file, role), dof) != frf::npos; }

void scale_channel(CheckedFile& file, Role role, const frf::Dof& dof, std::complex<double> factor) {
  if (!has_role(file, role, dof)) return;
  const auto at = static_cast<Eigen::Index>(place_of(dofs_of(file, role), dof));
  for (Eigen::MatrixXcd& line : file.frfs) {
    if (role == Role::response) {
      line.row(at) *= factor;
    } else {
      line.col(at) *= factor;
    }
  }
}

std::string channel_word(Role role) { return role == Role::response ? "sensor" : "hammer or shaker"; }
std::string role_key(const char* key, Role role) { return std::string(key) + (role == Role::response ? "" : "_reference"); }

void MeasuredChannels::add(const std::vector<CheckedFile>& files, std::size_t file, Role role, const frf::Dof& dof) {
  const auto same = [&](const MeasuredChannel& c) { return c.file == file && c.role == role && c.dof.same_coordinate(dof); };
  if (has_role(files[file], role, dof) && std::ranges::none_of(channels, same)) channels.push_back({file, role, dof});
}

}  // namespace jointid::ident
