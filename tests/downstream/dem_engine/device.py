"""The force model for DEM-Engine through NVIDIA's run-time compiler, as the engine compiles it; no accelerator is needed. Skipped
where the compiler is not there: build/venv/bin/pip install nvidia-cuda-nvrtc-cu12

device.py PLATEN FOLDER
"""
import ctypes
import pathlib
import subprocess
import sys

platen, out = sys.argv[1], pathlib.Path(sys.argv[2])
here = pathlib.Path(__file__).resolve().parent
package = "lib/python*/site-packages/nvidia/cuda_nvrtc/lib/libnvrtc.so*"
found = sorted((here.parents[2] / "build/venv").glob(package))
if not found:
    print("skipped: build/venv has no nvidia-cuda-nvrtc-cu12")
    sys.exit(77)
library = str(found[0])
out.mkdir(parents=True, exist_ok=True)
subprocess.run([platen, "export", "dem-engine", here.parents[2] / "examples/lammps/mcc-ph-200.toml", "--friction", "0.3", "--restitution", "0.5",
                "-o", out], check=True, stdout=subprocess.DEVNULL)

# what the engine has around a force model, as far as ours uses it
KERNEL = """
__device__ inline float3 operator+(float3 a, float3 b) { return make_float3(a.x + b.x, a.y + b.y, a.z + b.z); }
__device__ inline float3 operator-(float3 a, float3 b) { return make_float3(a.x - b.x, a.y - b.y, a.z - b.z); }
__device__ inline float3 operator*(float s, float3 a) { return make_float3(s * a.x, s * a.y, s * a.z); }
__device__ inline void operator+=(float3& a, float3 b) { a = a + b; }
__device__ inline float dot(float3 a, float3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
__device__ inline float3 cross(float3 a, float3 b) { return make_float3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x); }
__device__ inline void applyOriQToVector3(float3&, float4) {}
%s
extern "C" __global__ void forces(float* memory, const double* depth, const float3* v, float* out, float ARadius, float BRadius, float ts) {
  const int i = threadIdx.x;
  float &platen_max = memory[6 * i], &platen_max_rest = memory[6 * i + 1], &platen_t_x = memory[6 * i + 2], &platen_t_y = memory[6 * i + 3],
        &platen_t_z = memory[6 * i + 4], &platen_k = memory[6 * i + 5];
  const double overlapDepth = depth[i];
  const float3 ALinVel = v[2 * i], BLinVel = v[2 * i + 1], ARotVel = {}, BRotVel = {}, locCPA = {}, locCPB = {}, B2A = make_float3(0, 0, 1);
  const float4 AOriQ = {}, BOriQ = {};
  const float AOwnerMass = 1, BOwnerMass = 1;
  float3 force = {};
  { %s }
  out[i] = force.z;
}
""" % ((out / "functions.cu").read_text(), (out / "model.cu").read_text())

nvrtc = ctypes.CDLL(library)
program = ctypes.c_void_p()
assert nvrtc.nvrtcCreateProgram(ctypes.byref(program), KERNEL.encode(), b"platen.cu", 0, None, None) == 0
options = (ctypes.c_char_p * 2)(b"--std=c++17", b"--gpu-architecture=compute_70")
failed = nvrtc.nvrtcCompileProgram(program, 2, options)
size = ctypes.c_size_t()
nvrtc.nvrtcGetProgramLogSize(program, ctypes.byref(size))
log = ctypes.create_string_buffer(size.value)
nvrtc.nvrtcGetProgramLog(program, log)
if failed:
    sys.exit(log.value.decode()[:3000])
nvrtc.nvrtcGetPTXSize(program, ctypes.byref(size))
print(f"compiled for an accelerator: {size.value} bytes of PTX; {log.value.decode().strip() or 'no warnings'}")
