/// The queue's effects as rows.
#pragma once
#include <cstdint>

#include "scheduler/queue/job_queue.h"
#include "scheduler/rpc/book.h"
#include "store/store.h"

namespace regolab {

/// Inside an open transaction. `queue` is the one the effects came from, for the words of events.
Result<void> persist(const Effects& effects, const JobQueue& queue, Store& store, std::int64_t unix_ms);

/// What the book learns from them, once committed.
void note_in_book(const Effects& effects, const JobQueue& queue, Book& book, std::int64_t unix_ms);

/// "point 3 seed 1 repose: 38.2 deg"
std::string event_text(const EventNoted& event, const JobQueue& queue);

/// "stress 1.25 kPa", "repose"
std::string stage_text(const StageSpec& spec);

}  // namespace regolab
