/// What a verb talks to: a scheduler that runs somewhere, or one of our own for as long as the verb lasts.
#pragma once
#include <memory>
#include <string>

#include "client/arguments.h"
#include "client/console.h"
#include "client/embedded.h"
#include "client/lab.h"
#include "client/outcome.h"
#include "client/wire.h"

namespace regolab::client {

/// What the verb needs of the database in embedded mode. Only kCreate ever makes one.
enum class Need {
  kScratch,          ///< none: a temporary one will do
  kStoredOrScratch,  ///< the database if it exists, for what is stored in it
  kStored,           ///< it must exist
  kCreate,           ///< made if it does not exist
};

struct Session {
  std::unique_ptr<Embedded> embedded;  ///< empty when the scheduler is somebody else's
  std::unique_ptr<Lab> lab;            ///< destroyed first
  bool scratch = false;                ///< the database is a temporary one

  /// `outcome`, or why our own scheduler or workers ended, when that is the reason behind it.
  Outcome explain(Outcome outcome) const;
};

Outcome open_session(const Arguments& arguments, Need need, Session& session);

/// The id that "last", nothing, the start of an id or a name stands for. Nothing stands for the newest experiment, which is
/// said on stderr when there are several.
Outcome resolve_experiment(Lab& lab, const Arguments& arguments, Console& console, std::string& id);

/// The same for every word of `arguments.experiments`.
Outcome resolve_experiments(Lab& lab, const Arguments& arguments, Console& console, google::protobuf::RepeatedPtrField<std::string>& ids);

}  // namespace regolab::client
