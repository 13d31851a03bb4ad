// A dike beside a river, for tests of its level.
#pragma once

#include "sections.hpp"

namespace terp::test {

/// A dike of 4 m on ground at 0 m, its slopes of 1:2; river of 2 m at the left, -1 m inland, a head of 1 m below.
inline StixStage river_dike()
{
  StixStage stage = clay_on_sand();
  stage.layers[0].outline = {
      {-20.0, 0.0}, {-4.0, 0.0}, {4.0, 4.0}, {8.0, 4.0}, {16.0, 0.0}, {40.0, 0.0}, {40.0, -6.0}, {-20.0, -6.0}};
  stage.layers[1] = box_layer("sand", {-20.0, -10.0}, {40.0, -6.0}, 0);
  stage.water.head_lines = {
      {.id = "p", .label = "phreatic", .line = {{-20.0, 2.0}, {0.0, 2.0}, {16.0, -1.0}, {40.0, -1.0}}},
      {.id = "h", .label = "aquifer", .line = {{-20.0, 1.0}, {40.0, 0.5}}}};
  stage.water.reference_lines = {
      {.label = "top", .line = {{-20.0, -6.0}, {40.0, -6.0}}, .top_head = 1, .bottom_head = 1}};
  return stage;
}

}  // namespace terp::test
