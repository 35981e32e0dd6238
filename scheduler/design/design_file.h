/// design.yaml, or every reason why it cannot be run.
#pragma once
#include <map>
#include <string>

#include "input/diagnostic.h"
#include "scheduler/design/design.h"

namespace regolab {

struct DesignFiles {
  std::string text;                                ///< design.yaml itself
  std::string file_name;                           ///< for messages only
  std::map<std::string, std::string> attachments;  ///< files the design names (explicit tables), by the name it uses
};

/// What the command line says louder than the file.
struct DesignOverrides {
  std::string profile = {};  ///< empty = the file's
  unsigned seeds = 0;        ///< seeds 1..n for every point; 0 = the file's
};

/// All errors at once, sorted by place; an override's errors have line 0.
Read<Design> read_design(const DesignFiles& files, const DesignOverrides& overrides);

}  // namespace regolab
