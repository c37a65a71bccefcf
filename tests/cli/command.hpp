/// Runs the real `thalweg` binary in a folder of its own and looks at everything it leaves: code, streams,
/// files.
#pragma once

#include <gtest/gtest.h>
#include <sys/types.h>

#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace thalweg::test {

using Json = nlohmann::ordered_json;

/// How a run ended.
struct Outcome {
  int code = -1;  ///< exit code; 128 + signal if killed by one
  std::string out;
  std::string err;
  long peak_kilobytes = 0;  ///< of memory that was touched
};

/// A running command whose three streams are pipes of the test.
class Process {
 public:
  /// Starts the binary in `folder`, with stdin from `input_file` or, without one, from a pipe that stays open
  /// and empty until `close_input`. The new process calls `prepare` just before it becomes the command: for
  /// limits, say.
  Process(const std::string& folder, const std::vector<std::string>& arguments,
          const std::string& input_file = "", const std::function<void()>& prepare = {});
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  void close_input();
  /// Closes the reading end of its stdout, as `| head` does.
  void close_output();
  /// Waits until its stderr holds `text`; false if it ended first.
  bool await_error(const std::string& text);
  /// Waits until it has written something to stdout, and takes one byte of it.
  bool await_output();
  void send(int signal);
  /// Reads both streams to their ends and waits for the process.
  Outcome finish();

 private:
  pid_t pid_ = -1;
  int in_ = -1;
  int out_ = -1;
  int err_ = -1;
  Outcome seen_;
};

/// A fixture: an empty folder in which commands run.
class CommandTest : public ::testing::Test {
 protected:
  CommandTest();
  ~CommandTest() override;

  const std::string& folder() const { return folder_; }
  std::string path(const std::string& name) const { return folder_ + "/" + name; }
  void write(const std::string& name, const std::string& text) const;
  std::string read(const std::string& name) const;
  bool exists(const std::string& name) const;
  /// Names of all files, hidden ones too, sorted.
  std::vector<std::string> files() const;

  Outcome run(const std::vector<std::string>& arguments, const std::string& input = "") const;
  /// Runs with --json - added and parses what comes; `code` is what it must exit with.
  Json run_json(std::vector<std::string> arguments, int code = 0) const;

 private:
  std::string folder_;
};

/// Rows "x y z" of n random whole points in a square of side 10^6 with random elevations: the same for a
/// seed.
std::string noise(std::uint64_t n, std::uint64_t seed);

/// Names of the keys of an object, in order.
std::vector<std::string> keys(const Json& object);

/// The folder of the test data.
std::string data(const std::string& name);

}  // namespace thalweg::test
