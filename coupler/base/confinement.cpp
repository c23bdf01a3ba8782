// Landlock by its system calls, which the C library does not wrap: a set of rights that are handled (denied), rules that
// give them back below a folder, then restrict_self.

#include "coupler/base/confinement.h"

#include <fcntl.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>

#include "coupler/base/text.h"

namespace footfall {
namespace {

// linux/landlock.h, of which older systems have no or a shorter version. The numbers are the same on all architectures.
constexpr long kCreateRuleset = 444, kAddRule = 445, kRestrictSelf = 446;
constexpr unsigned kVersion = 1;  // flag of create_ruleset
constexpr int kPathBeneath = 1;   // kind of rule
constexpr std::uint64_t kExecute = 1 << 0, kWriteFile = 1 << 1, kRemoveFolder = 1 << 4, kMakeFolder = 1 << 7,
                        kRemoveFile = 1 << 5, kMakeFile = 1 << 8, kMakeLink = 1 << 12, kRefer = 1 << 13,
                        kTruncate = 1 << 14;
constexpr std::uint64_t kMakeOthers = 1 << 6 | 1 << 9 | 1 << 10 | 1 << 11;  // devices, sockets and pipes: never
constexpr std::uint64_t kOfFiles = kWriteFile | kTruncate;                  // the rights that a rule on a file may have

struct RulesetAttributes {
  std::uint64_t handled_fs;
};
struct PathBeneath {
  std::uint64_t allowed;
  std::int32_t parent;
} __attribute__((packed));

int landlock_version() {
  static const int version = static_cast<int>(syscall(kCreateRuleset, nullptr, 0, kVersion));
  return version < 0 ? 0 : version;
}

std::uint64_t handled_rights() {
  std::uint64_t rights =
      kExecute | kWriteFile | kRemoveFolder | kRemoveFile | kMakeFolder | kMakeFile | kMakeLink | kMakeOthers;
  if (landlock_version() >= 2) rights |= kRefer;
  if (landlock_version() >= 3) rights |= kTruncate;
  return rights;
}

bool allow(int ruleset, const std::string& path, std::uint64_t rights) {
  const int parent = open(path.c_str(), O_PATH | O_CLOEXEC);
  if (parent < 0) return true;  // nothing is there
  struct stat status {};
  if (fstat(parent, &status) == 0 && !S_ISDIR(status.st_mode)) rights &= kOfFiles | kExecute;
  const PathBeneath rule{rights & handled_rights(), parent};
  const bool added = syscall(kAddRule, ruleset, kPathBeneath, &rule, 0) == 0;
  close(parent);
  return added;
}

// The dynamic loader, which the kernel executes for every program.
std::string loader() {
  for (const char* path : {"/lib64/ld-linux-x86-64.so.2", "/lib/ld-linux-aarch64.so.1", "/lib64/ld64.so.2",
                           "/lib/ld-linux-armhf.so.3", "/lib/ld-linux.so.2", "/lib/ld-linux-riscv64-lp64d.so.1"})
    if (access(path, X_OK) == 0) return path;
  return "";
}

bool confine_files(const Confinement& confinement) {
  const RulesetAttributes attributes{confinement.limits_writing ? handled_rights() : kExecute};
  const int ruleset = static_cast<int>(syscall(kCreateRuleset, &attributes, sizeof attributes, 0));
  if (ruleset < 0) return false;
  bool done = true;
  const std::uint64_t writes = handled_rights() & ~(kExecute | kMakeOthers | kMakeLink);
  if (confinement.limits_writing) {
    for (const std::string& path : confinement.writable) done = done && allow(ruleset, path, writes);
    for (const char* device : {"/dev/null", "/dev/tty"}) done = done && allow(ruleset, device, kOfFiles);
  }
  for (const std::string& path : confinement.executable) done = done && allow(ruleset, path, kExecute);
  if (!confinement.executable.empty()) done = done && allow(ruleset, loader(), kExecute);
  done = done && syscall(kRestrictSelf, ruleset, 0) == 0;
  close(ruleset);
  return done;
}

// execve and execveat fail with EACCES.
bool confine_execution() {
  constexpr auto kNumber = static_cast<std::uint32_t>(offsetof(seccomp_data, nr));
  sock_filter filter[] = {
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, kNumber),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_execve, 1, 0),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_execveat, 0, 1),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | EACCES),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
  };
  const sock_fprog program{sizeof filter / sizeof filter[0], filter};
  // Without SPEC_ALLOW older kernels switch on a mitigation that costs speed.
  return syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, SECCOMP_FILTER_FLAG_SPEC_ALLOW, &program) == 0 ||
         syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, 0, &program) == 0;
}

}  // namespace

bool kernel_confines_files() { return landlock_version() > 0; }

std::string confine(const Confinement& confinement) {
  if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return std::string("no_new_privs: ") + std::strerror(errno);
  if (kernel_confines_files() && !confine_files(confinement)) return std::string("Landlock: ") + std::strerror(errno);
  // Where Landlock is missing, a kernel without seccomp is not confined at all; the check of the script has been strict.
  if (confinement.executable.empty() && !confine_execution() && !kernel_confines_files())
    return std::string("seccomp: ") + std::strerror(errno);
  return "";
}

bool script_is_confined() { return std::getenv(kMayWrite) != nullptr; }

std::vector<std::string> folders_of_script() {
  const char* folders = std::getenv(kMayWrite);
  return split(folders ? folders : "", '\n');
}

std::vector<std::string> folders_of_mpi() {
  std::vector<std::string> folders;
  for (const char* name : {"OMPI_MCA_orte_jobfam_session_dir", "PMIX_SERVER_TMPDIR", "OMPI_FILE_LOCATION",
                           "OMPI_MCA_btl_vader_backing_directory"})
    if (const char* folder = std::getenv(name); folder != nullptr && *folder == '/') folders.emplace_back(folder);
  return folders;
}

}  // namespace footfall
