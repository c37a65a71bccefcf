#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <string>
#include <utility>

#include "io/output_file.hpp"
#include "support/scratch_folder.hpp"

namespace thalweg::io {
namespace {

using test::content_of;

class OutputFiles : public testing::Test {
 protected:
  std::optional<Error> put(const std::string& path, std::string_view content,
                           const OutputOptions& options = {}) {
    auto file = OutputFile::open(path, options);
    if (!file) return file.error();
    file->write(content);
    return file->commit();
  }
  test::ScratchFolder folder_;
  const std::string big_ = std::string(3000000, 'x');
};

TEST_F(OutputFiles, AppearsWholeOnCommitAndNotBefore) {
  const std::string path = folder_ / "out.txt";
  auto file = OutputFile::open(path);
  ASSERT_TRUE(file);
  file->write("one ");
  file->write(big_);
  file->write(" two");
  EXPECT_EQ(file->size(), big_.size() + 8);
  EXPECT_FALSE(std::filesystem::exists(path));
  EXPECT_EQ(folder_.count(), 1u);
  EXPECT_FALSE(file->commit());
  EXPECT_EQ(content_of(path), "one " + big_ + " two");
  EXPECT_EQ(folder_.count(), 1u);
}

TEST_F(OutputFiles, WithoutCommitNothingIsLeft) {
  {
    auto file = OutputFile::open(folder_ / "out.txt");
    ASSERT_TRUE(file);
    file->write(big_);
    OutputFile moved = std::move(*file);
    moved.write("more");
    EXPECT_EQ(folder_.count(), 1u);
  }
  EXPECT_EQ(folder_.count(), 0u);
}

TEST_F(OutputFiles, ExistingFileIsKeptUnlessOverwritten) {
  const std::string path = folder_.put("out.txt", "old");
  for (const auto& error : {check_output(path, false), put(path, "new")}) {
    ASSERT_TRUE(error);
    EXPECT_EQ(error->code, ErrorCode::exists);
    EXPECT_EQ(error->message,
              path + ": exists already: say --overwrite to replace it, or choose another name");
  }
  EXPECT_EQ(content_of(path), "old");
  EXPECT_FALSE(check_output(path, true));
  EXPECT_FALSE(put(path, "new", {.overwrite = true}));
  EXPECT_EQ(content_of(path), "new");
  EXPECT_EQ(folder_.count(), 1u);
}

TEST_F(OutputFiles, FileThatAppearsMeanwhileIsNotReplaced) {
  const std::string path = folder_ / "out.txt";
  auto file = OutputFile::open(path);
  ASSERT_TRUE(file);
  file->write("mine");
  folder_.put("out.txt", "theirs");
  const auto error = file->commit();
  ASSERT_TRUE(error);
  EXPECT_EQ(error->code, ErrorCode::exists);
  EXPECT_EQ(content_of(path), "theirs");
  EXPECT_EQ(folder_.count(), 1u);
}

TEST_F(OutputFiles, InterruptedOverwriteLeavesTheOldFile) {
  const std::string path = folder_.put("out.txt", "old");
  {
    auto file = OutputFile::open(path, {.overwrite = true});
    ASSERT_TRUE(file);
    file->write(big_);
  }
  EXPECT_EQ(content_of(path), "old");
  EXPECT_EQ(folder_.count(), 1u);
}

TEST_F(OutputFiles, PermissionsAreThoseOfTheUmaskOrTheOldFile) {
  const mode_t before = ::umask(027);
  EXPECT_FALSE(put(folder_ / "new.txt", "x"));
  ::umask(before);
  struct stat status {};
  ASSERT_EQ(::stat((folder_ / "new.txt").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 07777, 0640u);
  ::chmod((folder_ / "new.txt").c_str(), 0604);
  EXPECT_FALSE(put(folder_ / "new.txt", "y", {.overwrite = true}));
  ASSERT_EQ(::stat((folder_ / "new.txt").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 07777, 0604u);
}

TEST_F(OutputFiles, SymbolicLinkStaysALink) {
  const std::string target = folder_.put("target.txt", "old");
  std::filesystem::create_symlink(target, folder_ / "link.txt");
  EXPECT_TRUE(put(folder_ / "link.txt", "new"));
  EXPECT_FALSE(put(folder_ / "link.txt", "new", {.overwrite = true}));
  EXPECT_TRUE(std::filesystem::is_symlink(folder_ / "link.txt"));
  EXPECT_EQ(content_of(target), "new");
}

TEST_F(OutputFiles, PlaceThatCannotBeWrittenIsRefusedWithTheReason) {
  ::mkdir((folder_ / "d").c_str(), 0700);
  const std::pair<std::string, std::string> cases[] = {
      {folder_ / "no/such/out.txt", "No such file or directory"},
      {folder_ / "d", "Is a directory"},
      {"", "needs a name"}};
  for (const auto& [path, reason] : cases) {
    for (const auto& error : {check_output(path, true), put(path, "x", {.overwrite = true})}) {
      ASSERT_TRUE(error) << path;
      EXPECT_EQ(error->code, ErrorCode::unwritable);
      EXPECT_NE(error->message.find(reason), std::string::npos) << error->message;
    }
  }
  if (::geteuid() == 0) return;
  ::chmod((folder_ / "d").c_str(), 0500);
  const auto error = check_output(folder_ / "d/out.txt", false);
  ASSERT_TRUE(error);
  EXPECT_EQ(error->message, (folder_ / "d/out.txt") + ": cannot be written: Permission denied");
}

TEST_F(OutputFiles, FullDiskIsReported) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  for (const std::string_view content : {std::string_view("short"), std::string_view(big_)}) {
    const auto error = put("/dev/full", content);
    ASSERT_TRUE(error);
    EXPECT_EQ(error->code, ErrorCode::unwritable);
    EXPECT_EQ(error->message, "/dev/full: cannot be written: No space left on device");
  }
}

TEST_F(OutputFiles, DevicesAreWrittenInPlace) {
  EXPECT_FALSE(check_output("/dev/null", false));
  EXPECT_FALSE(put("/dev/null", big_));
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST_F(OutputFiles, StandardOutputByEitherName) {
  const std::string path = folder_.put("stdout", "before|");
  const int saved = ::dup(STDOUT_FILENO);
  const int sink = ::open(path.c_str(), O_WRONLY | O_APPEND);
  ::dup2(sink, STDOUT_FILENO);
  const auto dash = put("-", "dash|");
  const auto name = put("/dev/stdout", "name|");
  const auto number = put("/dev/fd/1", "number");
  ::dup2(saved, STDOUT_FILENO);
  ::close(saved);
  ::close(sink);
  EXPECT_FALSE(dash);
  EXPECT_FALSE(name);
  EXPECT_FALSE(number);
  EXPECT_EQ(content_of(path), "before|dash|name|number");
}

TEST_F(OutputFiles, ClosedPipeIsReported) {
  const auto before = ::signal(SIGPIPE, SIG_IGN);
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  ::close(ends[0]);
  const auto error = put("/dev/fd/" + std::to_string(ends[1]), big_);
  ::close(ends[1]);
  ::signal(SIGPIPE, before);
  ASSERT_TRUE(error);
  EXPECT_EQ(error->code, ErrorCode::unwritable);
  EXPECT_NE(error->message.find("Broken pipe"), std::string::npos);
}

TEST_F(OutputFiles, CancelStopsWritingAndLeavesNothing) {
  std::atomic<bool> cancel = false;
  {
    auto file = OutputFile::open(folder_ / "out.txt", {.cancel = &cancel});
    ASSERT_TRUE(file);
    file->write(big_);
    EXPECT_FALSE(file->error());
    cancel = true;
    file->write(big_);
    ASSERT_TRUE(file->error());
    EXPECT_EQ(file->error()->code, ErrorCode::cancelled);
    EXPECT_TRUE(file->commit());
  }
  cancel = false;
  auto late = OutputFile::open(folder_ / "out.txt", {.cancel = &cancel});
  ASSERT_TRUE(late);
  late->write("x");
  cancel = true;
  EXPECT_TRUE(late->commit());
  EXPECT_EQ(folder_.count(), 0u);
}

}  // namespace
}  // namespace thalweg::io
