/// Runs the real `thalweg` binary.
#include "cli/command.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "cli/random.hpp"

namespace thalweg::test {
namespace {

namespace fs = std::filesystem;

struct Pipe {
  int read = -1;
  int write = -1;
};

Pipe make_pipe() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) ADD_FAILURE() << "no pipe";
  return {ends[0], ends[1]};
}

void close_end(int& descriptor) {
  if (descriptor >= 0) ::close(descriptor);
  descriptor = -1;
}

/// Appends what can be read now; false at the end of the stream.
bool take(int descriptor, std::string& text, std::size_t most = 65536) {
  std::string chunk(most, '\0');
  const ssize_t got = ::read(descriptor, chunk.data(), chunk.size());
  if (got > 0) text.append(chunk, 0, static_cast<std::size_t>(got));
  return got > 0;
}

int code_of(int status) {
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

Process::Process(const std::string& folder, const std::vector<std::string>& arguments,
                 const std::string& input_file, const std::function<void()>& prepare) {
  Pipe in = make_pipe();
  if (!input_file.empty()) {
    close_end(in.read);
    close_end(in.write);
    in.read = ::open(input_file.c_str(), O_RDONLY | O_CLOEXEC);
  }
  Pipe out = make_pipe();
  Pipe err = make_pipe();
  std::vector<std::string> words = {THALWEG_COMMAND};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  pid_ = fork();
  if (pid_ == 0) {
    dup2(in.read, STDIN_FILENO);
    dup2(out.write, STDOUT_FILENO);
    dup2(err.write, STDERR_FILENO);
    const bool arrived = chdir(folder.c_str()) == 0;
    if (prepare) prepare();
    if (arrived) execv(argv[0], argv.data());
    _exit(127);
  }
  close_end(in.read);
  close_end(out.write);
  close_end(err.write);
  in_ = in.write;
  out_ = out.read;
  err_ = err.read;
}

Process::~Process() {
  if (pid_ > 0) {
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
  close_end(in_);
  close_end(out_);
  close_end(err_);
}

void Process::close_input() {
  close_end(in_);
}
void Process::close_output() {
  close_end(out_);
}

bool Process::await_error(const std::string& text) {
  while (seen_.err.find(text) == std::string::npos) {
    if (!take(err_, seen_.err)) return false;
  }
  return true;
}

bool Process::await_output() {
  return take(out_, seen_.out, 1);
}

void Process::send(int signal) {
  kill(pid_, signal);
}

Outcome Process::finish() {
  std::array<pollfd, 2> streams = {pollfd{out_, POLLIN, 0}, pollfd{err_, POLLIN, 0}};
  while (streams[0].fd >= 0 || streams[1].fd >= 0) {
    if (poll(streams.data(), streams.size(), -1) < 0) continue;
    if (streams[0].revents != 0 && !take(out_, seen_.out)) streams[0].fd = -1;
    if (streams[1].revents != 0 && !take(err_, seen_.err)) streams[1].fd = -1;
  }
  int status = 0;
  rusage used{};
  wait4(pid_, &status, 0, &used);
  pid_ = -1;
  seen_.code = code_of(status);
  seen_.peak_kilobytes = used.ru_maxrss;
  return seen_;
}

CommandTest::CommandTest() {
  std::string name = (fs::temp_directory_path() / "thalweg-cli-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) ADD_FAILURE() << "no temporary folder";
  folder_ = name;
}

CommandTest::~CommandTest() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

void CommandTest::write(const std::string& name, const std::string& text) const {
  std::ofstream(path(name), std::ios::binary) << text;
}

std::string CommandTest::read(const std::string& name) const {
  std::ostringstream text;
  text << std::ifstream(path(name), std::ios::binary).rdbuf();
  return text.str();
}

bool CommandTest::exists(const std::string& name) const {
  return fs::exists(path(name));
}

std::vector<std::string> CommandTest::files() const {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_)) {
    names.push_back(entry.path().filename().string());
  }
  std::ranges::sort(names);
  return names;
}

Outcome CommandTest::run(const std::vector<std::string>& arguments, const std::string& input) const {
  const std::string input_file = folder_ + ".stdin";  // beside the folder, whose files tests count
  if (!input.empty()) std::ofstream(input_file, std::ios::binary) << input;
  Process process(folder_, arguments, input.empty() ? "" : input_file);
  process.close_input();
  const Outcome outcome = process.finish();
  std::error_code ignored;
  fs::remove(input_file, ignored);
  return outcome;
}

Json CommandTest::run_json(std::vector<std::string> arguments, int code) const {
  arguments.insert(arguments.end(), {"--json", "-"});
  const Outcome outcome = run(arguments);
  EXPECT_EQ(outcome.code, code) << outcome.err;
  Json parsed = Json::parse(outcome.out, nullptr, false);
  EXPECT_FALSE(parsed.is_discarded()) << outcome.out;
  return parsed;
}

std::string noise(std::uint64_t n, std::uint64_t seed) {
  cli::Random random(seed);
  std::string rows;
  for (std::uint64_t i = 0; i < n; ++i) {
    const std::uint64_t x = random.below(1000000);
    const std::uint64_t y = random.below(1000000);
    const std::uint64_t z = random.below(1000);
    rows += std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z) + "\n";
  }
  return rows;
}

std::vector<std::string> keys(const Json& object) {
  std::vector<std::string> names;
  for (const auto& item : object.items()) names.push_back(item.key());
  return names;
}

std::string data(const std::string& name) {
  return std::string(THALWEG_TEST_DATA) + "/" + name;
}

}  // namespace thalweg::test
