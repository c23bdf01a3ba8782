#pragma once
// Spectra and filters of a column at even times: shock response, power density, channel frequency classes.

#include <string>
#include <vector>

#include "mbd_solver/session/output/history.h"

namespace footfall {

struct Spectrum {
  std::vector<double> frequency;  // [Hz]
  std::vector<double> value;
};

// The step of the times [s]; a last row between two multiples does not count, `rows` is the number of those that do. Throws
// InputError for uneven times.
struct EvenTimes {
  double step;
  std::size_t rows;
};
EvenTimes even_times(const std::vector<double>& time, const std::string& file);

// Shock response spectrum: the largest absolute acceleration of oscillators with this quality Q = 1 / (2 zeta) on a base with
// the acceleration x, which is linear between samples [ISO 18431-4; Smallwood, Shock Vib. Bull. 51 (1981) 279]. Each starts at
// rest on x(0), and is followed for a period beyond the end, where x keeps its last value. Subdivided steps: 40 per period.
Spectrum shock_response(const std::vector<double>& x, double step, double quality,
                        const std::vector<double>& frequencies);
// A twelfth of an octave apart, from one period in the record to five samples per period.
std::vector<double> shock_frequencies(double step, std::size_t rows);

// One-sided power spectral density [unit^2/Hz] by Welch's mean over Hann windows of this many samples, three quarters
// overlapping, without their means. Their squares add up to a constant, so that all times count alike; for those near the ends
// the first and the last window count more.
Spectrum power_density(const std::vector<double>& x, double step, std::size_t window);
std::size_t default_window(std::size_t rows);  // an eighth of the record

// The low-pass filter of a channel frequency class (60, 180, 600, 1000) of SAE J211-1: Butterworth of second order, forwards
// and backwards, without a shift in time.
std::vector<double> class_filtered(const std::vector<double>& x, double step, int channel_class);

// The columns filtered, with the same times. Throws InputError for rows that are too rare for the class.
History filtered_history(const History& history, const std::vector<std::string>& columns, int channel_class,
                         const std::string& file);

}  // namespace footfall
