#pragma once
#include "coupler/base/errors.h"  // FileError stands there
