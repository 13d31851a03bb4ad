// What most of the program includes, read once where TERP_UNITY is on.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "run/measure/followers.hpp"
#include "io/case/case_file.hpp"
#include "io/case/key_text.hpp"
#include "io/files/files.hpp"
#include "run/loop/simulation.hpp"
#include "run/loop/stages.hpp"
#include "run/report/summary.hpp"
