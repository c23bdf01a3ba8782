#pragma once
// A part of a calibration's page.

#include <string>
#include <vector>

namespace footfall {

struct PagePart {
  std::string heading;                         // empty: goes on under the one before
  std::string text;                            // before the table
  std::vector<std::vector<std::string>> rows;  // the head first; empty: no table
  std::vector<std::string> pictures;           // PNG files
};

}  // namespace footfall
