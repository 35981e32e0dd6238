#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "client/commands/commands.h"
#include "client/json_view.h"
#include "vocab/stage.h"

namespace regolab::client {

Outcome version(const Arguments& arguments, Console& console) {
  if (arguments.json) {
    Json out = document("version");
    out["program"] = REGOLAB_VERSION;
    out["physics"] = kPhysicsVersion;
    console.out << text_of(out);
    return done();
  }
  console.out << fmt::format("regolab {} (physics version {}: results of other versions are never mixed with these)\n",
                             REGOLAB_VERSION, kPhysicsVersion);
  return done();
}

/// A bash function that offers verbs first and the verb's own options afterwards; files complete as usual.
Outcome completion(const Arguments&, Console& console) {
  std::string verbs;
  std::string cases;
  for (const auto& [verb, options] : known_words()) {
    if (verb.empty())
      cases += fmt::format("    *) words=\"{}\" ;;\n", fmt::join(options, " "));
    else {
      verbs += (verbs.empty() ? "" : " ") + verb;
      cases = fmt::format("    {}) words=\"{} --server --db --json --color\" ;;\n", verb, fmt::join(options, " ")) + cases;
    }
  }
  console.out << "_regolab() {\n  local words current=\"${COMP_WORDS[COMP_CWORD]}\"\n  case \"${COMP_WORDS[1]}\" in\n"
              << cases << "  esac\n"
              << fmt::format("  [ \"$COMP_CWORD\" = 1 ] && words=\"{}\"\n", verbs)
              << "  COMPREPLY=($(compgen -W \"$words\" -- \"$current\"))\n}\ncomplete -o default -F _regolab regolab\n";
  return done();
}

}  // namespace regolab::client
