// Bytes become four masks of 64 bits, and the grammar of a plain number is checked by shifts and one addition for all 64 at once. [Langdale and
// Lemire, VLDB J. 28 (2019) 941] do so for JSON.

#include "mbd_solver/base/number_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include "coupler/base/errors.h"
#include "mbd_solver/base/codes.h"

namespace footfall {
namespace {

constexpr std::size_t kBlockBytes = 64;      // of one mask
constexpr std::size_t kPageBytes = 1024;     // of text between two counts of words
constexpr std::size_t kHeadBytes = 65536;    // that are read at first
constexpr std::size_t kMostWhole = 8;        // digits before the point: more may be the mark of a hole
constexpr std::size_t kLongestWord = 256;    // > two blocks, since each block has a gap
constexpr std::size_t kChunkBytes = 262144;  // that are judged at once

bool is_decimal(char c) { return c >= '0' && c <= '9'; }
bool is_space(char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r' || c == ',' || c == ';'; }

#ifdef __SSE2__
// Bit k is the test result for byte k.
template <class Test>
std::uint64_t mask_of(const char* bytes, Test test) {
  std::uint64_t mask = 0;
  for (int k = 0; k < 4; ++k) {
    const __m128i v = _mm_loadu_si128(reinterpret_cast<const __m128i*>(bytes + 16 * k));
    mask |= static_cast<std::uint64_t>(static_cast<std::uint32_t>(_mm_movemask_epi8(test(v)))) << (16 * k);
  }
  return mask;
}
std::uint64_t mask_of(const char* bytes, char c) {
  const __m128i all = _mm_set1_epi8(c);
  return mask_of(bytes, [&](__m128i v) { return _mm_cmpeq_epi8(v, all); });
}
std::uint64_t digits_of(const char* bytes) {
  const __m128i zero = _mm_set1_epi8('0'), nine = _mm_set1_epi8(9);
  return mask_of(bytes, [&](__m128i v) {
    const __m128i above = _mm_sub_epi8(v, zero);
    return _mm_cmpeq_epi8(_mm_min_epu8(above, nine), above);
  });
}
#else
template <class Test>
std::uint64_t mask_of(const char* bytes, Test test) {
  std::uint64_t mask = 0;
  for (std::size_t k = 0; k < kBlockBytes; ++k) mask |= static_cast<std::uint64_t>(test(bytes[k])) << k;
  return mask;
}
std::uint64_t mask_of(const char* bytes, char c) {
  return mask_of(bytes, [c](char b) { return b == c; });
}
std::uint64_t digits_of(const char* bytes) { return mask_of(bytes, is_decimal); }
#endif

// The gaps in a block whose other bytes are known: mostly blanks and line ends.
std::uint64_t gaps_of(const char* bytes, std::uint64_t others) {
  std::uint64_t gaps = mask_of(bytes, ' ') | mask_of(bytes, '\n');
  if ((gaps | others) != ~std::uint64_t{0})
    for (const char c : {'\r', '\t', ',', ';'}) gaps |= mask_of(bytes, c);
  return gaps;
}

// Which words may be a hole, by their first digits.
class HoleSearch {
 public:
  explicit HoleSearch(double hole) : hole_(hole), any_(std::isfinite(hole)) {
    if (!any_) return;
    char digits[400];
    std::snprintf(digits, sizeof digits, "%.0f", std::floor(std::abs(hole)));
    first_ = digits[0];
    second_ = digits[1];
    zero_ = first_ == '0';
  }
  // starts: of words, with their minus.
  std::uint64_t candidates(const char* bytes, std::uint64_t starts, std::uint64_t minus, std::uint64_t after,
                           std::uint64_t points, std::uint64_t digits) const {
    if (!any_) return 0;
    const std::uint64_t heads = zero_ ? after | (starts & ~minus) : hole_ < 0.0 ? after : starts & ~minus;
    if (heads == 0) return 0;
    const std::uint64_t zeros = mask_of(bytes, '0');
    std::uint64_t next = ~std::uint64_t{0};
    if (second_ != '\0') next = mask_of(bytes, second_) >> 1 | std::uint64_t{1} << 63;
    const std::uint64_t leading = zeros & (digits >> 1 | std::uint64_t{1} << 63);
    const std::uint64_t same = zero_ ? zeros | points : mask_of(bytes, first_) & next;
    return heads & (same | leading);
  }
  // The word with this digit or point in front.
  bool found(const char* head, const char* end, bool minus) const {
    double value = 0.0;
    std::from_chars(head, end, value);
    return (minus ? -value : value) == hole_;
  }

 private:
  double hole_;
  bool any_, zero_ = false;
  char first_ = '\0', second_ = '\0';
};

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
  before_.reserve((size_ - begin) / kPageBytes + 2);
  std::vector<char> chunk(kChunkBytes + kBlockBytes);
  HoleSearch holes(hole);
  std::uint64_t words = 0;
  std::uint64_t gap = 1, minus = 0, digit = 0, lonely = 0, fraction = 0;  // of the byte before this block
  std::array<std::uint64_t, kMostWhole> whole{};                          // run, see below
  // A short or empty chunk is the last one: the line ends behind it end its last word.
  for (std::size_t from = begin, left = kChunkBytes; left == kChunkBytes; from += kChunkBytes) {
    left = bytes_at(from, kChunkBytes, chunk.data());
    std::fill(chunk.begin() + static_cast<std::ptrdiff_t>(left), chunk.end(), '\n');
    const std::size_t blocks = left == kChunkBytes ? kChunkBytes / kBlockBytes : left / kBlockBytes + 1;
    for (std::size_t b = 0; b < blocks; ++b) {
      const char* const bytes = chunk.data() + b * kBlockBytes;
      if (b % (kPageBytes / kBlockBytes) == 0) before_.push_back(static_cast<std::uint32_t>(words));
      const std::uint64_t D = digits_of(bytes), M = mask_of(bytes, '-'), P = mask_of(bytes, '.'),
                          G = gaps_of(bytes, D | M | P);
      const std::uint64_t behind_gap = G << 1 | gap, starts = ~G & behind_gap;
      std::uint64_t bad = ~(D | M | P | G);
      bad |= M & ~behind_gap;
      bad |= (M << 1 | minus) & ~(D | P);
      const std::uint64_t alone = P & ~(D << 1 | digit);  // a point without a digit before it
      bad |= (alone << 1 | lonely) & ~D;
      const std::uint64_t behind_point = P << 1 | fraction,
                          sum = behind_point + D;  // a run of digits carries to its end
      bad |= sum & ~D & ~G;
      const std::uint64_t behind_minus = M << 1 | minus;
      std::uint64_t run = (starts | behind_minus) & D;  // of digits before the point: their k-th
      for (std::uint64_t& ends : whole) {
        const std::uint64_t next = (run << 1 | ends) & D;
        ends = run >> 63;
        run = next;
      }
      if (bad != 0 || G == 0 || run != 0) return false;
      for (std::uint64_t may = holes.candidates(bytes, starts, M, behind_minus, P, D); may != 0; may &= may - 1) {
        const int at = __builtin_ctzll(may);
        if (b + 1 == kChunkBytes / kBlockBytes) {  // its word may end in the next chunk
          char word[kLongestWord];
          const std::size_t n = bytes_at(from + b * kBlockBytes + static_cast<std::size_t>(at), kLongestWord, word);
          if (holes.found(word, word + n, (behind_minus >> at & 1) != 0)) return false;
        } else if (holes.found(bytes + at, chunk.data() + chunk.size(), (behind_minus >> at & 1) != 0)) {
          return false;
        }
      }
      words += static_cast<std::uint64_t>(__builtin_popcountll(starts));
      gap = G >> 63;
      minus = M >> 63;
      digit = D >> 63;
      lonely = alone >> 63;
      fraction = P >> 63 | static_cast<std::uint64_t>(sum < D);
    }
  }
  return words == count;
}

void NumberFile::read(std::size_t first, std::size_t count, double* out) const {
  struct stat about {};
  if (fstat(file_, &about) != 0 || static_cast<std::size_t>(about.st_size) != size_ ||
      about.st_mtim.tv_sec * std::int64_t{1000000000} + about.st_mtim.tv_nsec != written_)
    throw FileError(code::kFileChanged,
                    path_ +
                        ": was changed while it was in use; start the run again, and leave the file as it is "
                        "until the run has ended");
  const auto page_of = [&](std::size_t word) {
    return static_cast<std::size_t>(std::upper_bound(before_.begin(), before_.end(), word) - before_.begin() - 1);
  };
  // From the byte before its page, which may be of a word of the page before, to the end of the last word.
  const std::size_t page = page_of(first), last = page_of(first + count - 1);
  const std::size_t before = page > 0 ? 1 : 0, from = begin_ + page * kPageBytes - before;
  std::vector<char> text((last + 1 - page) * kPageBytes + kLongestWord);
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
