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

#include "followers/followers.hpp"
#include "input/case_file.hpp"
#include "input/key_text.hpp"
#include "output/files.hpp"
#include "simulation/simulation.hpp"
#include "simulation/stages.hpp"
#include "simulation/summary.hpp"
