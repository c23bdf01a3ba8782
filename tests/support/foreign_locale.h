#pragma once
// The locale of a program that writes 1.234,5: of C++ always, of C where such a one is installed or localedef makes one.

#include <clocale>
#include <cstdlib>
#include <locale>
#include <string>

#include "tests/support/temporary_folder.h"

namespace footfall::test {

class ForeignLocale : TemporaryFolder {
 public:
  ForeignLocale() : before_(std::setlocale(LC_ALL, nullptr)) {
    const std::string place = file("de_DE.UTF-8");
    const std::string make = "localedef -i de_DE -f UTF-8 --no-archive '" + place + "' >/dev/null 2>&1";
    if (std::setlocale(LC_ALL, "de_DE.UTF-8") == nullptr && std::system(make.c_str()) == 0) {
      setenv("LOCPATH", folder_.c_str(), 1);
      std::setlocale(LC_ALL, "de_DE.UTF-8");
      unsetenv("LOCPATH");
    }
    std::locale::global(std::locale(std::locale::classic(), new Commas));
  }
  ~ForeignLocale() {
    std::locale::global(std::locale::classic());
    std::setlocale(LC_ALL, before_.c_str());
  }
  ForeignLocale(const ForeignLocale&) = delete;
  ForeignLocale& operator=(const ForeignLocale&) = delete;

 private:
  struct Commas : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };
  std::string before_;
};

}  // namespace footfall::test
