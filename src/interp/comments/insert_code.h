// Codes of turning inserts: ISO 1832 ("CNMG 120408") and the inch form ("CNMG-432"); of their
// holders (ISO 5608, "PCLNR 2525"), which give the shape.
#pragma once

#include "interp/comments/comment_tokens.h"

#include <cstddef>
#include <optional>
#include <string>

namespace mrsim {

struct InsertCode {
  std::string shape;               ///< "CNMG", "C" where a holder gives it
  double edge_length = 0;          ///< mm, of the cutting edge; of a round insert its diameter
  double nose_radius = 0;          ///< mm
  std::string other;               ///< letters of a second code with another corner or nose
  bool has_size = false;           ///< false: the letters stand alone
  double angle = 0;                ///< degrees, of the corner; 0 for a round insert
  double lead_angle = 0;           ///< degrees, of the usual holder for this shape
  std::size_t first = 0, end = 0;  ///< tokens [first, end) are the code
};

/// The first code of an insert among the tokens, else that of a holder. Letters without digits
/// count for the usual inserts only.
std::optional<InsertCode> find_insert_code(const std::vector<CommentToken>& tokens);

/// The unit, in mm, in which inserts have a nose radius of this value; 0 if they have none.
double usual_nose_unit(double value);

}  // namespace mrsim
