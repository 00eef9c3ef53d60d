#pragma once
// Whether the jaw is what the table and the route say it is. Each prints what it measured.

#include <vector>

#include "tools/content/mesh/model.h"
#include "tools/content/teeth/dentition.h"
#include "tools/content/teeth/route.h"

namespace fulcrum::content {

// Fourteen teeth, each as large as the table has it.
bool check_sizes(const Dentition& dentition, const Model& jaw);

// Every tooth touches its neighbours, and none is in another.
bool check_contacts(const Dentition& dentition);

// The expert's way touches nothing but what the tip is let down to.
bool check_way(const std::vector<RoutePose>& route, const TriangleTree& scene, const Model& explorer);

}  // namespace fulcrum::content
