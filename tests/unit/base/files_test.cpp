// Files and folders: written whole or not at all, locked, named, archived.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <limits>

#include "coupler/archive.h"
#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "coupler/message_fields.h"
#include "mbd_solver/base/csv.h"
#include "mbd_solver/base/lock.h"
#include "mbd_solver/base/named_file.h"
#include "tests/support/refused.h"
#include "tests/support/temporary_folder.h"

namespace footfall {
namespace {

namespace fs = std::filesystem;

// Tables: mbd_solver/base/csv.h.
class Csv : public ::testing::Test, protected TemporaryFolder {
 protected:
  using Rows = std::vector<std::vector<std::string>>;
  Rows rows(const std::string& text, CsvReader::Separators separators = CsvReader::Separators::kComma) {
    Rows all;
    for (CsvReader csv(write("table.csv", text), "a table", separators); csv.next(); last_line_ = csv.line())
      all.emplace_back(csv.cells().begin(), csv.cells().end());
    return all;
  }
  std::string refused(const std::string& text) {
    return test::error_of([&] { rows(text); });
  }
  int last_line_ = 0;
};

TEST_F(Csv, HasCellsInQuotes) {
  EXPECT_EQ(rows("a,b # c\n\n\"x,y\", \" # \"\"z\"\" \" ,\"\"\n"), (Rows{{"a", "b"}, {"x,y", " # \"z\" ", ""}}));
  EXPECT_EQ(rows("\"1.5\",2\r\n"), (Rows{{"1.5", "2"}}));
  EXPECT_EQ(rows("5\" pipe,\"\"\"\" # the \"first\"\n  # \"none\"\n"), (Rows{{"5\" pipe", "\""}}))
      << "a quote within a cell";
  EXPECT_EQ(rows("\"a b\"; c  \"d,e\"\n", CsvReader::Separators::kAny), (Rows{{"a b", "c", "d,e"}}));
}

TEST_F(Csv, HasEndsOfLinesInQuotes) {
  EXPECT_EQ(rows("\"one\n#two\r\n\",3\n4,5\n"), (Rows{{"one\n#two\r\n", "3"}, {"4", "5"}}));
  EXPECT_EQ(last_line_, 4) << "lines of the file are counted";
}

// Before, all lines had the cells of the first.
TEST_F(Csv, HasLinesThatEndInCarriageReturns) {
  EXPECT_EQ(rows("a,b\r1,2\r\r3,4\r"), (Rows{{"a", "b"}, {"1", "2"}, {"3", "4"}}));
  EXPECT_EQ(last_line_, 4);
}

TEST_F(Csv, NamesTheLineOfAQuoteThatIsWrong) {
  EXPECT_TRUE(test::names(refused("a,b\n1,\"2\n3,4\n"), {"table.csv:2: ", "E0251"}));
  EXPECT_TRUE(test::names(refused("a,b\n\"1\"2,3\n"), {"table.csv:2: ", "E0251"}));
}

class WholeFile : public ::testing::Test, protected TemporaryFolder {};

TEST_F(WholeFile, ReadsBackWhatWasWrittenByteByByte) {
  const std::string text("a\r\nb\0c\n", 7);
  write_whole_file(file("a"), text);
  EXPECT_EQ(read_whole_file(file("a")), text);
  write_whole_file(file("a"), "");
  EXPECT_EQ(read_whole_file(file("a")), "") << "an empty file is there; it takes the place of the old one";
  EXPECT_FALSE(read_whole_file(file("missing")));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1) << "no draft is left";
}

TEST_F(WholeFile, NamesTheFileThatCannotBeWritten) {
  const auto write = [&] { write_whole_file(file("no folder/a"), "text", "is the disk full?"); };
  EXPECT_TRUE(test::names(test::error_of(write), {file("no folder/a"), "is the disk full?"}));
}

// A file may have 1 kB here, as if the disk were full.
TEST_F(WholeFile, AFullDiskLeavesWhatWasThere) {
  write_whole_file(file("a"), "before");
  const pid_t child = fork();
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit most{1024, 1024};
    setrlimit(RLIMIT_FSIZE, &most);
    try {
      write_whole_file(file("a"), std::string(100000, 'x'));
    } catch (const InputError&) {
      _exit(7);
    }
    _exit(9);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(WEXITSTATUS(status), 7);
  EXPECT_EQ(text("a"), "before");
  EXPECT_FALSE(fs::exists(file("a.part")));
}

TEST_F(WholeFile, MakeFolderMakesThoseAroundItToo) {
  make_folder(file("x/y/z"));
  make_folder(file("x/y/z"));
  EXPECT_TRUE(fs::is_directory(file("x/y/z")));
  write_whole_file(file("a"), "a file is in the way");
  EXPECT_TRUE(test::names(test::error_of([&] { make_folder(file("a/b"), "choose another one"); }), {file("a/b")}));
}

class FileLocks : public ::testing::Test, protected TemporaryFolder {};

TEST_F(FileLocks, OneAtATime) {
  const std::string path = file("lock");
  {
    const FileLock first = FileLock::try_lock(path);
    EXPECT_TRUE(first.held());
    EXPECT_FALSE(FileLock::try_lock(path).held());
    EXPECT_EQ(owner_of(path), getpid());
  }
  EXPECT_TRUE(FileLock::try_lock(path).held());
}

TEST_F(FileLocks, AProgramThatWasStartedHoldsItOn) {
  const std::string path = file("lock");
  pid_t child = -1;
  {
    const FileLock lock = FileLock::try_lock(path);
    child = fork();
    if (child == 0) {
      pause();
      _exit(0);
    }
  }
  ASSERT_GT(child, 0);
  EXPECT_FALSE(FileLock::try_lock(path).held());
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  EXPECT_TRUE(FileLock::try_lock(path).held());
}

TEST_F(FileLocks, WaitingEndsWithTheHolder) {
  const std::string path = file("lock");
  FileLock first = FileLock::try_lock(path);
  int told = 0;
  const FileLock second = FileLock::wait_for(path, [&] {
    ++told;
    first = FileLock();
  });
  EXPECT_TRUE(second.held());
  EXPECT_EQ(told, 1);
}

TEST_F(FileLocks, AnOwnerThatNobodyHasCollectedIsDead) {
  EXPECT_TRUE(is_alive(getpid()));
  const pid_t child = fork();
  if (child == 0) _exit(0);
  siginfo_t info;
  waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOWAIT);
  EXPECT_FALSE(is_alive(child));
  waitpid(child, nullptr, 0);
  EXPECT_FALSE(is_alive(child));
  EXPECT_FALSE(is_alive(0));
}

TEST_F(FileLocks, WithoutItsFolderThereIsNone) { EXPECT_THROW(FileLock::try_lock(file("nowhere/lock")), InputError); }

class FolderLocks : public ::testing::Test, protected TemporaryFolder {};

TEST_F(FolderLocks, ASecondRunIsRefused) {
  const FileLock lock = lock_folder(file("run"));
  EXPECT_TRUE(test::names(test::error_of([&] { lock_folder(file("run")); }), {file("run")}));
  EXPECT_TRUE(lock_folder(file("other")).held());
}

TEST_F(FolderLocks, AProgramOfTheHolderIsNotRefused) {
  EXPECT_FALSE(folder_is_held_for_us(file("run")));
  setenv(kLockedFolder, locked_name(file("run")).c_str(), 1);
  EXPECT_TRUE(folder_is_held_for_us(file("run")));
  EXPECT_TRUE(folder_is_held_for_us(file("run/")));
  EXPECT_TRUE(folder_is_held_for_us(file("other/../run")));
  EXPECT_FALSE(folder_is_held_for_us(file("other")));
  unsetenv(kLockedFolder);
}

class NamedFile : public ::testing::Test, protected TemporaryFolder {};

TEST_F(NamedFile, GuessesWhichFileIsMeant) {
  write("drop.toml", "");
  const auto complaint = [&](const std::string& name) {
    return test::refusal([&] { require_file(file(name), "a sweep"); });
  };
  EXPECT_EQ(complaint("drop.toml"), "");
  EXPECT_TRUE(test::names(complaint("drap.toml"), {file("drap.toml"), file("drop.toml")}));
  EXPECT_NE(complaint("something_else"), "");
  EXPECT_NE(complaint("."), "");
}

struct Part {
  double x = 0.0;
  std::vector<bool> marks;
  void visit(Archive& archive) {
    archive("x", x);
    archive("marks", marks);
  }
};

struct Memory {
  bool yes = false;
  int n = 0;
  long steps = 0;
  double tiny = 0.0, endless = 0.0;
  std::string text;
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  Eigen::VectorXd rates;
  Eigen::MatrixXd table;
  std::array<double, 2> pair{};
  std::vector<Part> parts;
  std::optional<Part> there, absent;
  BodyLoad load;  // has a list of fields

  void visit(Archive& archive) {
    archive("yes", yes);
    archive("n", n);
    archive("steps", steps);
    archive("tiny", tiny);
    archive("endless", endless);
    archive("text", text);
    archive("place", place);
    archive("rates", rates);
    archive("table", table);
    archive("pair", pair);
    archive("parts", parts);
    archive("there", there);
    archive("absent", absent);
    archive("load", load);
  }
};

Memory example() {
  Memory m;
  m.yes = true;
  m.n = -7;
  m.steps = 1L << 40;
  m.tiny = std::numeric_limits<double>::denorm_min();
  m.endless = std::numeric_limits<double>::infinity();
  m.text = "two lines:\na \\ and an end ";
  m.place = {0.1, -1.0 / 3.0, 1e300};
  m.rates = Eigen::VectorXd::LinSpaced(5, 0.0, 0.3);
  m.table = Eigen::MatrixXd::Random(2, 3);
  m.pair = {1.0, 2.0};
  m.parts = {{0.7, {true, false, true}}, {0.2, {}}};
  m.there = Part{0.3, {false}};
  m.load.mean.F_W = {1.0, 2.0, 3.0};
  m.load.contacts = 4;
  m.load.tangent.resize(1);
  return m;
}

std::string text_of(Memory memory) {
  Archive archive;
  archive("memory", memory);
  return archive.text();
}

std::string complaint_about(const std::string& text) {
  return test::refusal([&] {
    Archive archive("run.txt", text);
    Memory memory;
    archive("memory", memory);
    archive.finish();
  });
}

TEST(Archive, RestoresEveryBit) {
  const std::string text = text_of(example());
  Archive archive("run.txt", text);
  Memory restored;
  archive("memory", restored);
  archive.finish();
  EXPECT_EQ(text_of(restored), text);
  const Memory e = example();
  EXPECT_EQ(restored.tiny, e.tiny);
  EXPECT_EQ(restored.endless, e.endless);
  EXPECT_EQ(restored.text, e.text);
  EXPECT_EQ(restored.place, e.place);
  EXPECT_EQ(restored.rates, e.rates);
  EXPECT_EQ(restored.parts[0].marks, e.parts[0].marks);
  EXPECT_FALSE(restored.absent.has_value());
  EXPECT_EQ(restored.load.mean.F_W, e.load.mean.F_W);
}

TEST(Archive, OfAnotherMemoryIsRefusedWithItsLine) {
  const std::string text = text_of(example());
  std::string other = text;
  other.replace(other.find("memory/n "), 9, "memory/m ");
  EXPECT_TRUE(test::names(complaint_about(other), {"run.txt:2:", "memory/n", "memory/m"}));
  EXPECT_NE(complaint_about(text + "more 1\n"), "");
  EXPECT_NE(complaint_about(text.substr(0, text.size() - 3)), "");
}

TEST(Archive, VectorsOfAnotherLengthAreRefused) {
  Eigen::VectorXd five = Eigen::VectorXd::Ones(5), four = Eigen::VectorXd::Ones(4), none;
  Archive save;
  save("q", five);
  Archive fits("run.txt", save.text()), too_long("run.txt", save.text());
  fits("q", none);
  EXPECT_EQ(none, five);
  EXPECT_THROW(too_long("q", four), InputError);
}

// Rows without columns were taken for rows of one number each, which nobody had made room for.
TEST(Archive, ShapesThatATypeCannotHaveAreRefused) {
  for (const char* text : {"q 3 0\n", "q 0 3\n", "q 1 3 1 2 3\n", "q -1 1\n"}) {
    Eigen::VectorXd q;
    Archive archive("run.txt", text);
    EXPECT_THROW(archive("q", q), InputError) << text;
  }
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  Archive lying("run.txt", "r 1 3 0x1p+0 0x1p+0 0x1p+0\n");
  EXPECT_THROW(lying("r", place), InputError);
}

}  // namespace
}  // namespace footfall
