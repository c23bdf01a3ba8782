#pragma once
// view.html: one file that plays a run in 3D, with plots in step. It needs no network, and forbids itself any.

#include <string>

namespace footfall {

struct ViewArguments {
  std::string run;  // folder of a run
  int frames = 0;   // dumps of the grains, at most; 0: all that a page of about 100 MB holds
};

// Writes RUN/view.html and returns its path. Throws InputError when the folder holds no run, or files of it are damaged.
std::string write_view(const ViewArguments& arguments);

// There are grains or bodies to be played.
bool has_frames(const std::string& run);

}  // namespace footfall
