#include "worker/dem/team.h"

#include <memory>

namespace regolab::dem {
namespace {

constexpr int kSpins = 4000;  // about 100 us

void relax() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#endif
}

/// Waits until `value` is no longer `old`: spinning first, then asleep.
template <class T>
void await_change(const std::atomic<T>& value, T old) {
  for (int i = 0; i < kSpins; ++i) {
    if (value.load(std::memory_order_acquire) != old) return;
    relax();
  }
  value.wait(old, std::memory_order_acquire);
}

}  // namespace

Team::Team(int threads) {
  for (int t = 1; t < threads; ++t) others_.emplace_back([this, t] { serve(t); });
}

Team::~Team() {
  over_ = true;
  round_.fetch_add(1, std::memory_order_release);
  round_.notify_all();
}

void Team::start(Call call, const void* work) {
  call_ = call;
  work_ = work;
  busy_.store(size() - 1, std::memory_order_relaxed);
  round_.fetch_add(1, std::memory_order_release);
  round_.notify_all();
  call(work, 0);
  for (int left = busy_.load(std::memory_order_acquire); left != 0; left = busy_.load(std::memory_order_acquire)) {
    await_change(busy_, left);
  }
}

void Team::serve(int t) {
  for (unsigned seen = 0;; ++seen) {
    await_change(round_, seen);
    if (over_) return;
    call_(work_, t);
    busy_.fetch_sub(1, std::memory_order_release);
    busy_.notify_one();
  }
}

Team& my_team(int threads) {
  thread_local std::unique_ptr<Team> team;
  if (!team || team->size() != threads) team = std::make_unique<Team>(threads);
  return *team;
}

}  // namespace regolab::dem
