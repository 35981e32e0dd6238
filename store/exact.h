/// Doubles in SQLite, bit for bit. A REAL column turns NaN into NULL and -0.0 into 0.0; those keep their bits in a column
/// beside.
#pragma once
#include <bit>
#include <cmath>

#include "store/database.h"

namespace regolab {

/// Binds two columns: the value for readers, the bits where the value alone would not come back.
inline void bind_exact(Statement& statement, double value) {
  const bool odd = std::isnan(value) || (value == 0 && std::signbit(value));
  statement.bind(value);  // NaN becomes NULL
  if (odd)
    statement.bind(std::bit_cast<std::int64_t>(value));
  else
    statement.bind_null();
}

/// Reads what bind_exact() wrote into columns `column` and `column + 1`; nullopt when both are NULL.
inline std::optional<double> read_exact(const Statement& statement, int column) {
  if (!statement.null(column + 1)) return std::bit_cast<double>(statement.integer(column + 1));
  if (statement.null(column)) return std::nullopt;
  return statement.real(column);
}

}  // namespace regolab
