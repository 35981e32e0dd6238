/// The desk's held calls: long polls of workers that wait for an order.
#include <memory>
#include <utility>

#include "scheduler/rpc/desk.h"

namespace regolab {

void Desk::hold(HeldCall call) {
  if (auto older = take_held(call.worker)) older->answer(OrderKeep{});  // the worker has given up on it
  if (call.idle) idle_[call.id] = call.worker;
  held_[call.worker] = std::move(call);
}

std::optional<Desk::HeldCall> Desk::take_held(const std::string& worker) {
  auto node = held_.extract(worker);
  if (node.empty()) return std::nullopt;
  idle_.erase(node.mapped().id);
  return std::move(node.mapped());
}

void Desk::let_go(const std::string& worker, std::uint64_t id) {
  const auto held = held_.find(worker);
  if (held == held_.end() || held->second.id != id) return;
  const auto call = take_held(worker);
  queue_->forget_idle(worker);
  call->answer(OrderKeep{});
}

void Desk::answer_all_held(const std::optional<Order>& order) {
  auto calls = std::move(held_);
  held_.clear();
  idle_.clear();
  for (auto& [worker, call] : calls) call.answer(order);
}

/// Orders for held calls, made in this transaction and sent after it.
void Desk::serve_held(Turn& turn, std::vector<Pending>& pending) {
  const auto reply = [&](const std::string& worker, Order order) {
    auto call = take_held(worker);
    if (!call) return;
    auto send = std::make_shared<HeldCall>(std::move(*call));
    pending.push_back(
        {[send, order = std::move(order)] { send->answer(order); }, [send](const Error&) { send->answer(OrderKeep{}); }});
  };
  for (const std::string& worker : revoked_) reply(worker, OrderDrop{"the lease has ended (cancelled)"});
  while (!read_only_ && queue_->anything_ready() && !idle_.empty()) {
    const std::string worker = idle_.begin()->second;
    auto order = queue_->poll(worker, turn.now, turn.effects);
    reply(worker, order ? std::move(*order) : Order(OrderKeep{}));
  }
  std::vector<std::string> late;
  for (const auto& [worker, call] : held_) {
    if (call.until <= turn.now) late.push_back(worker);
  }
  for (const std::string& worker : late) reply(worker, OrderKeep{});
}

}  // namespace regolab
