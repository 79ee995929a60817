// The text for DEM-Engine on a processor: what the engine has around a force model, as far as ours uses it.
// Reads lines "R1 R2 overlap", writes the force of each in double (`platen_contact`) and as the model adds it
// up, with float memory. With an argument: what an impact returns.
#include <cmath>
#include <cstdio>
#include <functional>

struct float3 {
  float x, y, z;
};
float3 make_float3(float x, float y, float z) { return {x, y, z}; }
float3 operator+(float3 a, float3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
float3 operator-(float3 a, float3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
float3 operator*(float s, float3 a) { return {s * a.x, s * a.y, s * a.z}; }
float3& operator+=(float3& a, float3 b) { return a = a + b; }
float dot(float3 a, float3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
float3 cross(float3 a, float3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
struct float4 {
  float x, y, z, w;
};
void applyOriQToVector3(float3&, float4) {} // bodies that have not turned

#include "functions.cu"

#include "../adapters/bounce.hpp"

int main(int argc, char**) {
  float platen_max = 0, platen_max_rest = 0, platen_t_x = 0, platen_t_y = 0, platen_t_z = 0, platen_k = 0;
  const float3 BLinVel{}, ARotVel{}, BRotVel{}, locCPA{}, locCPB{}, B2A{0, 0, 1};
  const float4 AOriQ{}, BOriQ{};
  const float AOwnerMass = 1, BOwnerMass = 1, ts = 1e-6f;
  const auto force_of = [&](double R1, double R2, double overlapDepth, double v) {
    const double ARadius = R1, BRadius = R2;
    const float3 ALinVel{0, 0, static_cast<float>(v)};
    float3 force{};
#include "model.cu"
    return static_cast<double>(force.z);
  };
  if (argc > 1) // masses are 1 kg
    return bounce(0.5, 1e-3, 1e-6,
                  [&](double overlap, double v) { return force_of(1e-3, 1e-3, overlap, v); });
  double R1, R2, overlap, last1 = 0, last2 = 0;
  while (std::scanf("%lf %lf %lf", &R1, &R2, &overlap) == 3) {
    if (R1 != last1 || R2 != last2) platen_max = platen_max_rest = 0; // another pair
    last1 = R1, last2 = R2;
    double largest = static_cast<double>(platen_max) + platen_max_rest;
    const double force = force_of(R1, R2, overlap, 0);
    largest = std::fmax(largest, overlap);
    std::printf("%.17g %.9g %.17g\n", platen_contact(R1, R2, overlap, largest).force, force,
                static_cast<double>(platen_max) + platen_max_rest);
  }
}
