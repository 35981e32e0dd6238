/// What a diagnosis has worked out so far: one that was stopped takes up its finished steps and ends with the same bits.
#pragma once
#include <functional>
#include <optional>
#include <string>

#include "scheduler/gap/smc.h"

namespace regolab::gap {

struct GroupGap;

/// Finished steps by name, as bytes. Both may be empty: nothing is remembered.
struct StepMemory {
  std::function<std::optional<std::string>(const std::string& name)> find;
  std::function<void(const std::string& name, const std::string& bytes)> keep;
};

/// Bit for bit; nothing when the bytes are not ours.
std::string bytes_of(const Posterior& posterior);
std::string bytes_of(const std::vector<GroupGap>& where);
std::optional<Posterior> posterior_from(const std::string& bytes);
std::optional<std::vector<GroupGap>> where_from(const std::string& bytes);

namespace detail {
template <class Value, class From, class Make>
Value remembered(const StepMemory* memory, const std::string& name, const From& from, const Make& make) {
  if (memory && memory->find) {
    const auto bytes = memory->find(name);
    if (auto known = bytes ? from(*bytes) : std::optional<Value>()) return std::move(*known);
  }
  Value made = make();
  if (memory && memory->keep) memory->keep(name, bytes_of(made));
  return made;
}
}  // namespace detail

/// The step of that name as it was found before, else made now and kept.
template <class Make>
Posterior remembered_posterior(const StepMemory* memory, const std::string& name, const Make& make) {
  return detail::remembered<Posterior>(memory, name, posterior_from, make);
}
template <class Make>
std::vector<GroupGap> remembered_where(const StepMemory* memory, const std::string& name, const Make& make) {
  return detail::remembered<std::vector<GroupGap>>(memory, name, where_from, make);
}

}  // namespace regolab::gap
