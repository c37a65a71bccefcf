/// Jobs in a list, and threads that look there.
#include "kernel/thread_team.hpp"

#include <chrono>
#include <new>
#include <system_error>

namespace thalweg::detail {
namespace {

thread_local ThreadTeam* current_team = nullptr;

/// Waits until ready(), but not long, and lets others have the processor meanwhile.
template <class Ready>
void look_until(const Ready& ready) {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::microseconds kPatience(200);
  for (const auto end = Clock::now() + kPatience; !ready() && Clock::now() < end;) std::this_thread::yield();
}

}  // namespace

ThreadTeam::~ThreadTeam() {
  {
    const std::lock_guard guard(lock_);
    over_ = true;
    ++news_;
  }
  posted_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void ThreadTeam::post(Job& job) {
  const unsigned helpers = job.wanted;
  {
    const std::lock_guard guard(lock_);
    job.next = jobs_;
    jobs_ = &job;
    ++news_;
    start_threads(helpers);
  }
  helpers == 1 ? posted_.notify_one() : posted_.notify_all();
}

/// Waits for those who have begun; nobody begins any more.
void ThreadTeam::withdraw(Job& job) {
  std::unique_lock guard(lock_);
  Job** link = &jobs_;
  while (*link != &job) link = &(*link)->next;
  *link = job.next;
  if (job.running > 0) {
    guard.unlock();
    look_until([&] { return job.running == 0; });
    guard.lock();
  }
  ended_.wait(guard, [&] { return job.running == 0; });
}

ThreadTeam::Job* ThreadTeam::open_job() const noexcept {
  for (Job* job = jobs_; job != nullptr; job = job->next) {
    if (job->wanted > 0) return job;
  }
  return nullptr;
}

/// Returns when there is one, when the team is over, or after a while. Others can post meanwhile.
void ThreadTeam::look_for_job(std::unique_lock<std::mutex>& guard) {
  if (over_ || open_job() != nullptr) return;
  const unsigned known = news_;
  guard.unlock();
  look_until([&] { return news_ != known; });
  guard.lock();
}

/// So that so many are idle, if there may be as many.
void ThreadTeam::start_threads(unsigned idle) {
  try {
    for (; idle_ < idle && threads_.size() < most_; ++idle_) threads_.emplace_back([this] { help(); });
  } catch (const std::system_error&) {
    // No more threads to be had: those there are do the work.
  } catch (const std::bad_alloc&) {
    // The same for want of memory.
  }
}

void ThreadTeam::help() {
  current_team = this;
  std::unique_lock guard(lock_);
  for (;;) {
    look_for_job(guard);
    posted_.wait(guard, [this] { return over_ || open_job() != nullptr; });
    Job* const job = open_job();
    if (job == nullptr) return;
    --job->wanted;
    ++job->running;
    --idle_;
    guard.unlock();
    job->call(job->context);
    guard.lock();
    ++idle_;
    job->wanted = 0;
    if (--job->running == 0) ended_.notify_all();
  }
}

TeamScope::TeamScope(unsigned threads) {
  if (current_team == nullptr) current_team = &own_.emplace(threads);
  team_ = current_team;
}

TeamScope::~TeamScope() {
  if (own_) current_team = nullptr;
}

}  // namespace thalweg::detail
