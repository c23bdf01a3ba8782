#pragma once
// Runs that differ only by chance, such as by the sample of the bed: mean and band of their curves.

#include <string>
#include <vector>

#include "mbd_solver/app/plots.h"
#include "mbd_solver/session/output/history.h"

namespace footfall {

// The file of a sweep that lists the runs of each case: `case,run`, folders relative to the
// sweep's.
inline constexpr const char* kSamplesFile = "samples.csv";
// A band has this share of the samples below its lower edge, and above its upper edge.
inline constexpr double kBeyondBand = 0.05;
inline constexpr const char* kBandWords = "5 to 95 %";

struct SampledCase {
  std::string name;               // of the case; of a single run, the name of its folder
  std::vector<std::string> runs;  // folders, at least one
};

bool is_sweep(const std::string& folder);  // of results, instead of a run
// The cases of the sweep in this folder, or its run as a single case. Throws InputError where it is
// neither.
std::vector<SampledCase> cases_in(const std::string& folder);
// The cases of both folders, with the folder's name in front, or in its place where it has a single
// case.
std::vector<SampledCase> cases_in(const std::string& a, const std::string& b);

// Sample quantile: value k of n in order, counted from 0, has the share k / (n - 1); straight
// between them. values: not empty.
double quantile_of(std::vector<double> values, double share);

// These columns of all cases on one clock: "COLUMN (k)" is the mean over the runs of case k,
// counted from 1; "COLUMN (k low)" and "COLUMN (k high)" are the edges of the band where the case
// has several runs. Rows are the first run's in the time that all runs cover. Throws InputError for
// a run without a column, or without common time.
History bands_on_one_clock(const std::vector<SampledCase>& cases, const std::vector<std::string>& columns);

// The curves of one case on a page: every column is the mean over its runs; with several runs
// "COLUMN 5 %" and "COLUMN 95 %" are the edges of its band. Throws as bands_on_one_clock.
History curves_of(const SampledCase& sampled);

// A figure per column of bands_on_one_clock, with a curve per case.
std::vector<Figure> figures_of_bands(const std::vector<SampledCase>& cases, const History& bands,
                                     const std::vector<std::string>& columns);

}  // namespace footfall
