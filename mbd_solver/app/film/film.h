#pragma once
// footfall view --png and --video, and check --picture: what the page of a run shows, as files. Chromium draws (page_camera.h),
// ffmpeg makes videos. Nothing else of footfall needs either.

#include <string>
#include <vector>

#include "mbd_solver/scene/scene.h"

namespace footfall {

struct FilmArguments {
  std::string run;               // folder of a run
  std::string other;             // of a second one, as a ghost; empty: none
  std::string file;              // .png; .mp4 or .webm
  int frames = 0;                // dumps of grains in the page, at most; 0: as many as fit into about 100 MB
  std::vector<int> size;         // width, height [pixels]; empty: 1280, 720
  std::vector<double> camera;    // azimuth, elevation [deg], zoom [-]; empty: as the page opens
  std::string show;              // more of what follows the # of the page's address: "grains=force&track=cabin"
  double at = -1.0;              // of --png [s]; negative: the middle of the run
  double from = 0.0, to = -1.0;  // of --video [s]; negative: the end
  double rate = 30.0;            // pictures in a second of --video
  double slow = 0.0;             // seconds of the video per second of the run; 0: so that it lasts 5 to 12 s
};

// Each writes its file, prints its path and returns the exit code. Throw InputError (also for missing programs, which it
// names), PartnerError.
int draw_page_picture(const FilmArguments& arguments);
int make_video(const FilmArguments& arguments);

// check --picture FILE: the mechanism in its reference configuration, with the axes of its joints. Without Chromium a FILE.png
// is drawn more plainly, by gnuplot. FILE.html: the page itself.
int draw_reference(const Scene& scene, const std::string& file);

}  // namespace footfall
