#!/bin/bash
# Every law compiled for two generations of GPU, by nvcc or by Clang; no GPU is needed. Skipped, by name, where neither is.
# With Clang (16 or later, which knows sm_90) the headers may be NVIDIA's of PyPI:
#   build/venv/bin/pip install nvidia-cuda-runtime-cu12 nvidia-cuda-nvcc-cu12 nvidia-cuda-cccl-cu12
# device.sh SOURCE
set -eu
source=$1
unit=$source/tests/downstream/law/device.cu
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT

if command -v nvcc >/dev/null; then
  for arch in sm_80 sm_90; do
    nvcc -std=c++20 --expt-relaxed-constexpr -arch="$arch" -I"$source/include" -c "$unit" -o "$out/device.o"
    echo "nvcc, $arch: every law compiled"
  done
  exit
fi
for clang in clang++-19 clang++-18 clang++-17 clang++-16; do command -v "$clang" >/dev/null && break; done
command -v "$clang" >/dev/null || { echo "skipped: neither nvcc nor Clang 16 or later"; exit 77; }
packages=$(echo "${PLATEN_CUDA:-$source/build/venv}"/lib/python*/site-packages/nvidia)
[ -d "$packages/cuda_runtime/include" ] && [ -d "$packages/cuda_nvcc/nvvm" ] ||
  { echo "skipped: build/venv has no nvidia-cuda-runtime-cu12, nvidia-cuda-nvcc-cu12, nvidia-cuda-cccl-cu12"; exit 77; }
mkdir -p "$out/cuda/include" # as a CUDA toolkit lies
for part in cuda_runtime cuda_nvcc cuda_cccl; do
  [ ! -d "$packages/$part/include" ] || cp -rsf "$packages/$part/include/." "$out/cuda/include"
done
: >"$out/cuda/include/curand_mtgp32_kernel.h" # Clang includes it; no random numbers here
ln -s "$packages/cuda_nvcc/nvvm" "$out/cuda/nvvm"
ln -s "$packages/cuda_nvcc/bin" "$out/cuda/bin"
for arch in sm_80 sm_90; do
  "$clang" -std=c++20 --cuda-path="$out/cuda" --cuda-gpu-arch="$arch" --cuda-device-only -Wno-unknown-cuda-version -O2 \
    -I"$source/include" -x cuda -S "$unit" -o "$out/device.ptx"
  kernels=$(grep -c '^\.visible \.entry\|^\.entry' "$out/device.ptx")
  [ "$kernels" -ge 11 ] || { echo "$arch: $kernels kernels only"; exit 1; } # the table's, and of ten laws the formulas
  "$packages/cuda_nvcc/bin/ptxas" -arch="$arch" "$out/device.ptx" -o "$out/device.cubin"
  echo "$clang, $arch: $kernels kernels"
done
