#pragma once
// Where in its script LIGGGHTS stood when it stopped, by its log.

#include <map>
#include <string>

namespace footfall {

// What to say of a log that holds errors: where, the ERROR lines, and what they mean where that is known.
std::string why_liggghts_stopped(const std::string& log, const std::string& script,
                                 const std::map<std::string, std::string>& variables);

// "FILE:LINE: COMMAND" of the script's last line that the log repeats before its first ERROR; the script's name alone
// where none is found.
std::string where_liggghts_stopped(const std::string& log, const std::string& script,
                                   const std::map<std::string, std::string>& variables);

}  // namespace footfall
