/// Threads that are kept for as long as a call takes, and wait for work in between.
#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace thalweg::detail {

/// Shares work with threads of its own. They are started when they are first needed, and end with the team:
/// to wake one takes a fraction of the time in which one is started, and a call shares work twenty times.
/// Whoever has nothing to do looks for it for a while before it sleeps, since where a hypervisor has to be
/// asked, to wake it takes a tenth of a millisecond.
class ThreadTeam {
 public:
  /// Of at most so many threads, the calling one included.
  explicit ThreadTeam(unsigned threads) noexcept : most_(threads == 0 ? 0 : threads - 1) {}
  ~ThreadTeam();
  ThreadTeam(const ThreadTeam&) = delete;
  ThreadTeam& operator=(const ThreadTeam&) = delete;

  /// Calls run() here and, at the same time, in up to `helpers` threads of the team that have nothing else to
  /// do; fewer if the system grants no more. Once a call has ended, which should mean that nothing is left to
  /// do, no other begins. Returns when all have ended. What runs may share work in turn. Requires: run() does
  /// not throw.
  template <class Run>
  void share(const Run& run, unsigned helpers) {
    Job job{[](const void* of) { (*static_cast<const Run*>(of))(); }, &run, helpers, 0, nullptr};
    post(job);
    run();
    withdraw(job);
  }

 private:
  /// In a list of those that have been posted and not withdrawn, the latest first.
  struct Job {
    void (*call)(const void*);
    const void* context;
    unsigned wanted;                ///< helpers that may still begin
    std::atomic<unsigned> running;  ///< helpers that have begun and not ended
    Job* next;
  };

  void post(Job& job);
  void withdraw(Job& job);
  Job* open_job() const noexcept;
  void start_threads(unsigned idle);
  void help();

  std::mutex lock_;  // of all that follows, for whoever changes it
  std::condition_variable posted_, ended_;
  std::atomic<unsigned> news_{0};  ///< one more for every job, and for the end
  Job* jobs_ = nullptr;
  std::vector<std::thread> threads_;
  unsigned most_;
  unsigned idle_ = 0;
  bool over_ = false;
};

/// The team of the calling thread, which it shares its work with while this exists: the one it has already,
/// or a new one of at most so many threads.
class TeamScope {
 public:
  explicit TeamScope(unsigned threads);
  ~TeamScope();
  TeamScope(const TeamScope&) = delete;
  TeamScope& operator=(const TeamScope&) = delete;

  ThreadTeam& team() const noexcept { return *team_; }

 private:
  std::optional<ThreadTeam> own_;
  ThreadTeam* team_;
};

}  // namespace thalweg::detail
