#pragma once
// A large file of numbers, such as a height map: validated once, and read where it is needed.
// Plain numbers are digits, at most 8 before at most one point, and a minus; gaps are blanks, line ends, commas and
// semicolons. A reader with complete messages reads all other texts.

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace footfall {

// A plain number at `at`, of at most 15 digits, and a gap or the end behind it. Nothing is passed if there is another word.
bool read_plain_number(const char*& at, const char* end, double& value);

class NumberFile {
 public:
  static std::shared_ptr<NumberFile> open(const std::string& path);  // null when it cannot be read
  ~NumberFile();
  NumberFile(const NumberFile&) = delete;
  NumberFile& operator=(const NumberFile&) = delete;

  std::string_view head() const { return text_; }  // its first bytes, or all
  bool all_in_head() const { return text_.size() == size_; }
  std::string_view whole();  // all
  // From byte `begin` on are `count` plain numbers, none of which is `hole`. Only then their numbers can be read.
  bool judge(std::size_t begin, std::size_t count, double hole);
  // Nearest doubles. Throws FileError when the file was changed after it was opened.
  void read(std::size_t first, std::size_t count, double* out) const;

 private:
  NumberFile() = default;
  std::size_t bytes_at(std::size_t begin, std::size_t count, char* out) const;  // how many there are

  std::string path_, text_;
  int file_ = -1;
  std::size_t size_ = 0, begin_ = 0;
  std::int64_t written_ = 0;           // [ns since 1970]
  std::vector<std::uint32_t> before_;  // words that begin before each page
};

}  // namespace footfall
