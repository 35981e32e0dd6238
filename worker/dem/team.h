/// The threads of one step. Phases last some hundred microseconds, so a thread that waits spins for about as long before it sleeps:
/// waking a sleeper would cost as much as the phase, and spinning for good would starve other work on a busy machine.
#pragma once
#include <atomic>
#include <thread>
#include <vector>

namespace regolab::dem {

class Team {
 public:
  explicit Team(int threads);
  ~Team();
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;

  int size() const { return static_cast<int>(others_.size()) + 1; }

  /// work(t) for t = 0 .. size() - 1, the caller being 0; returns when all are done. `work` must not throw.
  template <class Work>
  void run(const Work& work) {
    start([](const void* to_do, int t) { (*static_cast<const Work*>(to_do))(t); }, &work);
  }

 private:
  using Call = void (*)(const void*, int);
  void start(Call call, const void* work);
  void serve(int t);

  Call call_ = nullptr;               // these three are written before the round goes up
  const void* work_ = nullptr;
  bool over_ = false;
  std::atomic<unsigned> round_{0};    // goes up when there is work
  std::atomic<int> busy_{0};          // threads still at it
  std::vector<std::jthread> others_;  // last: they stop before the rest goes
};

/// The calling thread's own team of this size, kept until it asks for another.
Team& my_team(int threads);

}  // namespace regolab::dem
