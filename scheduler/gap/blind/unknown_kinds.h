/// Departures that no effect of the library is: what "none of these" has to be said of. Each is something that happens in laboratories.
#pragma once
#include <span>
#include <string>
#include <string_view>

#include "scheduler/gap/blind/chance.h"
#include "scheduler/gap/blind/truth.h"

namespace regolab::gap {

struct UnknownKind {
  std::string_view name;
  std::string_view what;          ///< happens
  std::string_view nearest;       ///< effect of the library, and what tells it apart
  std::string_view parameters;    ///< and their ranges
  bool by_dem;                    ///< runs differ; else only what is recorded of them
  void (*draw)(Chance&, Truth&);  ///< fills `parameters`, and moves the material where it must
};

std::span<const UnknownKind> unknown_kinds();
/// Null when there is none of that name.
const UnknownKind* find_unknown(std::string_view name);

}  // namespace regolab::gap
