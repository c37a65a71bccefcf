/// Jobs in a list, and threads that look there.
#include "kernel/thread_team.hpp"

#include <chrono>
#include <new>
#include <system_error>

namespace thalweg::detail {
namespace {

thread_local ThreadTeam* current_team = nullptr;

/// Waits until ready(), which is asked with the lock held. Looks for `sign` without it, though not for long,
/// and lets others have the processor meanwhile; then sleeps.
template <class Ready, class Sign>
void wait_until(const Ready& ready, const Sign& sign, std::unique_lock<std::mutex>& guard,
                std::condition_variable& wake) {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::microseconds kPatience(200);
  if (!ready()) {
    guard.unlock();
    for (const auto end = Clock::now() + kPatience; !sign() && Clock::now() < end;) std::this_thread::yield();
    guard.lock();
  }
  wake.wait(guard, ready);
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
  const auto all_ended = [&job] { return job.running == 0; };
  wait_until(all_ended, all_ended, guard, ended_);
}

ThreadTeam::Job* ThreadTeam::open_job() const noexcept {
  for (Job* job = jobs_; job != nullptr; job = job->next) {
    if (job->wanted > 0) return job;
  }
  return nullptr;
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
    wait_until([this] { return over_ || open_job() != nullptr; },
               [this, known = news_.load()] { return news_ != known; }, guard, posted_);
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
