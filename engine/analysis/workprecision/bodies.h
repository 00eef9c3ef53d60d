#pragma once
// What the studies touch, and what they touch it with.

#include <memory>
#include <random>
#include <span>
#include <vector>

#include "haptics/bake/field_bake.h"
#include "haptics/geometry/feature_mesh.h"
#include "haptics/geometry/pointshell.h"

namespace fulcrum::analysis::workprecision {

// The bodies are ours and sound: a refusal is a mistake in a study.
std::shared_ptr<const DistanceField> field_of(const TriangleMesh& mesh, double voxel,
                                              FieldFormat format = FieldFormat::int16);

std::vector<std::shared_ptr<const DistanceField>> fields_of(const TriangleMesh& mesh,
                                                            std::span<const double> voxels_mm);

std::shared_ptr<const FeatureMesh> features_of(const TriangleMesh& mesh);

Vec3 random_direction(std::mt19937_64& random);

// Turns by the golden angle: evenly spread however many are taken, and the same every time.
double golden_angle(int i);  // rad, -pi to pi

// Directions spread evenly over the sphere.
std::vector<Vec3> fibonacci_sphere(int count);

// The points that are to touch, and enough others on a sphere of `inside` m, which never do, to make the
// shell one of kShellPoints: a query costs what it costs a tool of that many.
inline constexpr int kShellPoints = 4096;
std::shared_ptr<const Pointshell> shell_touching(std::span<const Vec3> points, std::span<const Vec3> normals,
                                                 double inside);

// A ball's whole surface, `spacing` m from point to point.
std::shared_ptr<const Pointshell> ball_shell(double radius, double spacing);

}  // namespace fulcrum::analysis::workprecision
