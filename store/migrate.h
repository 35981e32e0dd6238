/// Brings a database file to the schema this program knows.
#pragma once
#include "store/database.h"

namespace regolab {

inline constexpr int kApplicationId = 0x5245474f;  ///< "REGO"
inline constexpr int kSchemaVersion = 7;

/// Reads only. kFailedPrecondition: the file is another program's, or a newer regolab's.
Result<void> check_header(Database& db);
/// REQUIRES: check_header() was content. All steps in one transaction.
Result<void> migrate(Database& db);

}  // namespace regolab
