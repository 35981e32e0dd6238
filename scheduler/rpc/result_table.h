/// The table range analysis, comparison and export read, from the rows of an experiment.
#pragma once
#include "store/reader.h"
#include "vocab/result_table.h"

namespace regolab {

struct NamedTable {
  ResultTable table;
  std::string name;  ///< of the design
};

/// A cell without a number carries the reason: "not settled (...)", "pending", "cancelled", "failed: ...".
Result<NamedTable> result_table(Reader& reader, const std::string& label);

}  // namespace regolab
