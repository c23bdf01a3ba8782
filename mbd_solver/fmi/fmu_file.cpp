// libzip reads the archive. Entries are written below the given folder only; their number and unpacked sizes are counted while
// they are read, because the sizes that the archive announces need not be true.

#include "mbd_solver/fmi/fmu_file.h"

#include <zip.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <set>

#include "coupler/base/text.h"
#include "mbd_solver/base/budget.h"

namespace footfall {
namespace {

namespace fs = std::filesystem;

constexpr const char* kDescription = "modelDescription.xml";
constexpr std::size_t kElfHead = 4;  // [bytes]

#if defined(__x86_64__)
constexpr const char *kPlatform3 = "x86_64-linux", *kPlatform2 = "linux64";
#elif defined(__aarch64__)
constexpr const char *kPlatform3 = "aarch64-linux", *kPlatform2 = "aarch64-linux";
#else
constexpr const char *kPlatform3 = "this machine", *kPlatform2 = "this machine";
#endif

using Zip = std::unique_ptr<zip_t, decltype(&zip_discard)>;

void take(ReadBudget& budget, std::uint64_t amount) {
  if (!budget.takes(amount)) throw FmuProblem("limit", budget.excess());
}

// All that is unpacked of the archive.
ReadBudget unpacked_budget(const std::string& file) {
  std::error_code none;
  const std::uint64_t most = limit::kFmuSmall + limit::kFmuRatio * fs::file_size(file, none);
  return {limit::kFmuUnpacked, file, std::min(most, limit::kFmuUnpacked.most)};
}

Zip opened(const std::string& file) {
  int code = 0;
  Zip zip(zip_open(file.c_str(), ZIP_RDONLY, &code), zip_discard);
  if (zip) {
    ReadBudget entries(limit::kFmuEntries, file);
    take(entries, static_cast<std::uint64_t>(zip_get_num_entries(zip.get(), 0)));
    return zip;
  }
  zip_error_t error;
  zip_error_init_with_code(&error, code);
  const std::string why = zip_error_strerror(&error);
  zip_error_fini(&error);
  throw FmuProblem("file", "is no FMU: it is no zip archive, or damaged (" + why + "); export it again");
}

// The entry in pieces, to a function.
void read_entry(zip_t* zip, zip_uint64_t index, ReadBudget& bytes_left,
                const std::function<void(const char*, std::size_t)>& write) {
  const char* const name = zip_get_name(zip, index, 0);
  const std::unique_ptr<zip_file_t, decltype(&zip_fclose)> entry(zip_fopen_index(zip, index, 0), zip_fclose);
  if (!entry) throw FmuProblem("file", std::string("its entry ") + name + " cannot be read: " + zip_strerror(zip));
  std::vector<char> bytes(1 << 16);
  for (zip_int64_t count = 0; (count = zip_fread(entry.get(), bytes.data(), bytes.size())) != 0;) {
    if (count < 0)
      throw FmuProblem("file", std::string("its entry ") + name + " is damaged (" + zip_file_strerror(entry.get()) +
                                   "); export the FMU again");
    take(bytes_left, static_cast<std::uint64_t>(count));
    write(bytes.data(), static_cast<std::size_t>(count));
  }
}

// Names of the folders binaries/NAME/ that hold a library.
std::set<std::string> platforms(zip_t* zip) {
  std::set<std::string> names;
  for (zip_int64_t i = 0; i < zip_get_num_entries(zip, 0); ++i) {
    const std::string name = zip_get_name(zip, static_cast<zip_uint64_t>(i), 0);
    const std::vector<std::string> parts = split(name, '/');
    if (parts.size() == 3 && parts[0] == "binaries" && !parts[2].empty()) names.insert(parts[1]);
  }
  return names;
}

// Where an entry is unpacked, relative to the folder. Throws FmuProblem for a place outside of it.
fs::path place_of(const std::string& name) {
  fs::path inside = fs::path(name).lexically_normal();
  if (inside.is_absolute() || inside.empty() || *inside.begin() == ".." || name.find('\\') != std::string::npos)
    throw FmuProblem("file", "has the entry \"" + name + "\", which lies outside of the archive; export it again");
  return inside;
}

// Reads the whole library, which compares its sum, and checks that its first bytes belong to an ELF file of this machine.
void check_library(zip_t* zip, zip_uint64_t index, const std::string& name, ReadBudget bytes_left) {
  std::string head;
  read_entry(zip, index, bytes_left, [&](const char* bytes, std::size_t count) {
    if (head.size() < kElfHead) head.append(bytes, std::min(count, kElfHead));
  });
  if (head != "\177ELF")
    throw FmuProblem("file", "its entry " + name + " is no library of Linux; export or compile it again");
}

}  // namespace

std::string library_path(const FmuDescription& d) {
  return std::string("binaries/") + (d.version[0] == '2' ? kPlatform2 : kPlatform3) + "/" + d.identifier + ".so";
}

FmuDescription read_fmu(const std::string& file) {
  const Zip zip = opened(file);
  const zip_int64_t index = zip_name_locate(zip.get(), kDescription, 0);
  if (index < 0)
    throw FmuProblem("file",
                     std::string("is no FMU: the archive has no ") + kDescription + " at its top; export it again");
  std::string xml;
  ReadBudget bytes_left(limit::kFmuDescription, file);
  read_entry(zip.get(), static_cast<zip_uint64_t>(index), bytes_left,
             [&](const char* bytes, std::size_t count) { xml.append(bytes, count); });
  FmuDescription description = parse_model_description(xml);
  for (zip_int64_t i = 0; i < zip_get_num_entries(zip.get(), 0); ++i)
    place_of(zip_get_name(zip.get(), static_cast<zip_uint64_t>(i), 0));
  const std::string path = library_path(description);
  const zip_int64_t library = zip_name_locate(zip.get(), path.c_str(), 0);
  if (description.obstacle.empty() && library >= 0)
    check_library(zip.get(), static_cast<zip_uint64_t>(library), path, unpacked_budget(file));
  if (description.obstacle.empty() && library < 0) {
    const std::set<std::string> found = platforms(zip.get());
    description.obstacle =
        "platform the FMU has no " + path + ", which this machine needs; it has " +
        (found.empty() ? "no libraries at all" : "libraries for " + joined({found.begin(), found.end()})) +
        ": export or compile it for this platform";
  }
  return description;
}

void unpack_fmu(const std::string& file, const std::string& folder) {
  const Zip zip = opened(file);
  const zip_int64_t count = zip_get_num_entries(zip.get(), 0);
  ReadBudget bytes_left = unpacked_budget(file);
  for (zip_int64_t i = 0; i < count; ++i) {
    const auto index = static_cast<zip_uint64_t>(i);
    const std::string name = zip_get_name(zip.get(), index, 0);
    const fs::path path = fs::path(folder) / place_of(name);
    if (name.back() == '/') {
      fs::create_directories(path);
      continue;
    }
    fs::create_directories(path.parent_path());
    std::ofstream out(path, std::ios::binary);
    read_entry(zip.get(), index, bytes_left,
               [&](const char* bytes, std::size_t size) { out.write(bytes, static_cast<std::streamsize>(size)); });
    out.close();
    if (!out) throw FmuProblem("file", "cannot be unpacked to " + path.string() + ": the disk may be full");
  }
}

void write_fmu(const std::string& file, const std::vector<FmuEntry>& entries) {
  const auto fail = [&](const std::string& why) { throw FmuProblem("file", "cannot be written: " + why); };
  const std::string draft = file + ".part";
  std::error_code ignored;
  int code = 0;
  Zip zip(zip_open(draft.c_str(), ZIP_CREATE | ZIP_TRUNCATE, &code), zip_discard);
  if (!zip) fail("the folder does not exist or may not be written");
  for (const FmuEntry& entry : entries) {
    zip_source_t* const source = entry.file.empty()
                                     ? zip_source_buffer(zip.get(), entry.text.data(), entry.text.size(), 0)
                                     : zip_source_file(zip.get(), entry.file.c_str(), 0, -1);
    const zip_int64_t index = source ? zip_file_add(zip.get(), entry.name.c_str(), source, ZIP_FL_ENC_UTF_8) : -1;
    if (index < 0) fail(entry.name + ": " + zip_strerror(zip.get()));
    const zip_uint32_t mode = entry.program ? 0100755 : 0100644;
    zip_file_set_external_attributes(zip.get(), static_cast<zip_uint64_t>(index), 0, ZIP_OPSYS_UNIX, mode << 16);
  }
  if (zip_close(zip.get()) != 0) {
    const std::string why = zip_strerror(zip.get());
    fs::remove(draft, ignored);
    fail(why);
  }
  zip.release();
  fs::rename(draft, file);
}

}  // namespace footfall
