#pragma once
// Range checks of the parameters of laws and controllers. Each throws InputError:
//   "<law>: <name> is <value> <unit>; expected ...".

#include <string_view>

namespace footfall {

void require_positive(std::string_view law, std::string_view name, double value, std::string_view unit);
void require_not_negative(std::string_view law, std::string_view name, double value, std::string_view unit);
void require_finite(std::string_view law, std::string_view name, double value, std::string_view unit);
void require_within(std::string_view law, std::string_view name, double value, double low, double high,
                    std::string_view unit);

}  // namespace footfall
