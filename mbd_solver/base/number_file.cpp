// A plain word is passed byte by byte. Words that begin before each page of the text are counted, so that numbers are found again.

#include "mbd_solver/base/number_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>

#include "coupler/base/errors.h"
#include "mbd_solver/base/codes.h"

namespace footfall {
namespace {

constexpr std::size_t kPageBytes = 1024;   // of text between two counts of words
constexpr std::size_t kHeadBytes = 65536;  // that are read at first
constexpr std::ptrdiff_t kMostWhole = 8;   // digits before the point: more may be the mark of a hole
constexpr std::ptrdiff_t kLongestWord = 128;
constexpr std::size_t kChunkBytes = 262144;  // that are judged at once

bool is_decimal(char c) { return c >= '0' && c <= '9'; }
bool is_space(char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r' || c == ',' || c == ';'; }

// Behind the plain number at `word`: at the gap, or at `end` if the text may continue there. Null: another word, or the hole.
const char* end_of_plain(const char* const word, const char* const end, double hole) {
  const char* at = word;
  if (*at == '-') ++at;
  const char* const first = at;
  double whole = 0.0;
  for (; at < end && is_decimal(*at); ++at) whole = 10.0 * whole + (*at - '0');
  std::ptrdiff_t digits = at - first;
  if (digits > kMostWhole) return nullptr;
  if (at < end && *at == '.') {
    const char* const point = at++;
    while (at < end && is_decimal(*at)) ++at;
    digits += at - point - 1;
  }
  if (at == end) return at;
  if (digits == 0 || !is_space(*at) || at - word > kLongestWord) return nullptr;
  if (whole != std::floor(std::abs(hole))) return at;
  double value = 0.0;
  std::from_chars(first, at, value);
  return (first > word ? -value : value) == hole ? nullptr : at;
}

}  // namespace

// Both parts of the quotient, and with them the nearest double, are exact [Clinger, PLDI 1990].
bool read_plain_number(const char*& from, const char* end, double& value) {
  static constexpr std::array<double, 16> kTens = {1.0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                   1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
  const char* at = from;
  const bool negative = at < end && *at == '-';
  if (negative) ++at;
  std::uint64_t digits = 0;
  const char* const first = at;
  for (; at < end && is_decimal(*at); ++at) digits = 10 * digits + static_cast<unsigned>(*at - '0');
  std::ptrdiff_t count = at - first, behind = 0;
  if (at < end && *at == '.') {
    const char* const point = at++;
    for (; at < end && is_decimal(*at); ++at) digits = 10 * digits + static_cast<unsigned>(*at - '0');
    behind = at - point - 1;
    count += behind;
  }
  if (count == 0 || count > 15 || (at < end && !is_space(*at))) return false;
  value = static_cast<double>(digits) / kTens[behind];
  if (negative) value = -value;
  from = at;
  return true;
}

std::shared_ptr<NumberFile> NumberFile::open(const std::string& path) {
  std::shared_ptr<NumberFile> out(new NumberFile);
  out->path_ = path;
  out->file_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  struct stat about {};
  if (out->file_ < 0 || fstat(out->file_, &about) != 0 || !S_ISREG(about.st_mode)) return nullptr;
  out->size_ = static_cast<std::size_t>(about.st_size);
  out->written_ = about.st_mtim.tv_sec * std::int64_t{1000000000} + about.st_mtim.tv_nsec;
  out->text_.resize(std::min(out->size_, kHeadBytes));
  if (out->bytes_at(0, out->text_.size(), out->text_.data()) < out->text_.size()) return nullptr;
  return out;
}

NumberFile::~NumberFile() {
  if (file_ >= 0) close(file_);
}

std::size_t NumberFile::bytes_at(std::size_t begin, std::size_t count, char* out) const {
  std::size_t done = 0;
  while (done < count) {
    const ssize_t n = pread(file_, out + done, count - done, static_cast<off_t>(begin + done));
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) break;
    done += static_cast<std::size_t>(n);
  }
  return done;
}

std::string_view NumberFile::whole() {
  if (!all_in_head()) {
    text_.resize(size_);
    text_.resize(bytes_at(0, size_, text_.data()));
    size_ = text_.size();
  }
  return text_;
}

bool NumberFile::judge(std::size_t begin, std::size_t count, double hole) {
  FOOTFALL_DEMAND(begin <= size_);
  begin_ = begin;
  before_.clear();
  std::vector<char> chunk(kChunkBytes + 1);
  std::size_t words = 0, from = begin, cut = 0;  // cut: bytes of a word that the chunk before did not have in full
  for (bool last = false; !last;) {
    const std::size_t size = cut + bytes_at(from + cut, kChunkBytes - cut, chunk.data() + cut);
    last = size < kChunkBytes;
    if (last) chunk[size] = '\n';
    const char* const end = chunk.data() + size + (last ? 1 : 0);
    const char* at = chunk.data();
    for (cut = 0; at < end;) {
      if (is_space(*at)) {
        ++at;
        continue;
      }
      const char* const behind = end_of_plain(at, end, hole);
      if (behind == nullptr || (behind == end && end - at > kLongestWord)) return false;
      if (behind == end) {
        cut = static_cast<std::size_t>(end - at);
        break;
      }
      const std::size_t place = from - begin + static_cast<std::size_t>(at - chunk.data());
      while (before_.size() * kPageBytes <= place) before_.push_back(static_cast<std::uint32_t>(words));
      ++words;
      at = behind;
    }
    from += size - cut;
    std::memmove(chunk.data(), at, cut);
  }
  return words == count;
}

void NumberFile::read(std::size_t first, std::size_t count, double* out) const {
  struct stat about {};
  if (fstat(file_, &about) != 0 || static_cast<std::size_t>(about.st_size) != size_ ||
      about.st_mtim.tv_sec * std::int64_t{1000000000} + about.st_mtim.tv_nsec != written_)
    throw FileError(
        code::kFileChanged, path_,
        ": was changed while it was in use; start the run again, and leave the file as it is until the run has ended");
  const auto page_of = [&](std::size_t word) {
    return static_cast<std::size_t>(std::upper_bound(before_.begin(), before_.end(), word) - before_.begin() - 1);
  };
  // From the byte before its page, which may be of a word of the page before, to the end of the last word.
  const std::size_t page = page_of(first), last = page_of(first + count - 1);
  const std::size_t before = page > 0 ? 1 : 0, from = begin_ + page * kPageBytes - before;
  std::vector<char> text((last + 1 - page) * kPageBytes + kLongestWord + 2);
  const std::size_t size = bytes_at(from, text.size(), text.data());
  const char* at = text.data();
  const char* const end = at + size;
  if (before > 0)
    while (at < end && !is_space(*at)) ++at;
  const std::size_t skip = first - before_[page];
  for (std::size_t k = 0; k < skip + count; ++k) {
    while (at < end && is_space(*at)) ++at;
    FOOTFALL_DEMAND(at < end);
    if (k < skip) {
      while (at < end && !is_space(*at)) ++at;
    } else if (double& value = out[k - skip]; !read_plain_number(at, end, value)) {
      at = std::from_chars(at, end, value).ptr;
    }
  }
}

}  // namespace footfall
