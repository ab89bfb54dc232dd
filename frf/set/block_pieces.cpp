#include "frf/set/block_pieces.hpp"

namespace jointid::frf {

BlockPiece find_piece(const FrfHeader& header, std::size_t source, const std::vector<Dof>& rows,
                      const std::vector<Dof>& columns, bool transposed) {
  BlockPiece piece{.source = source,
                   .responses = {},
                   .references = {},
                   .rows = {},
                   .columns = {},
                   .response_sign = {},
                   .reference_sign = {},
                   .transposed = transposed};
  const auto match = [](const std::vector<Dof>& wanted, const std::vector<Dof>& stored, std::vector<std::size_t>& place,
                        std::vector<std::size_t>& index, std::vector<double>& sign) {
    std::size_t next = 0;  // mostly stored in the order in which they are wanted
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      const bool follows = next < stored.size() && stored[next].same_coordinate(wanted[i]);
      const std::size_t found = follows ? next : find_coordinate(stored, wanted[i]);
      if (found == npos) continue;
      next = found + 1;
      place.push_back(i);
      index.push_back(found);
      sign.push_back(wanted[i].sign * stored[found].sign);
    }
  };
  match(transposed ? columns : rows, header.response, piece.rows, piece.responses, piece.response_sign);
  match(transposed ? rows : columns, header.reference, piece.columns, piece.references, piece.reference_sign);
  return piece;
}

}  // namespace jointid::frf
