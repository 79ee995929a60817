#!/bin/bash
# Every law, and the bench of bench/gpu, compiled for two generations of GPU by each compiler that is there, nvcc and Clang: each
# refuses what the other takes. No GPU is needed. Skipped, by name, where neither is. Both are had without a toolkit:
#   nvcc 13:  build/venv/bin/pip install nvidia-{cuda-nvcc,nvvm,cuda-crt,cuda-runtime,cuda-cccl}==13.0.*
#   Clang 16 or later, which knows sm_90, with NVIDIA's headers:
#             build/venv/bin/pip install nvidia-cuda-runtime-cu12 nvidia-cuda-nvcc-cu12 nvidia-cuda-cccl-cu12
# device.sh SOURCE
set -eu
source=$1
units="tests/downstream/law/device.cu bench/gpu/law_bench.cu"
packages=$(echo "${PLATEN_CUDA:-$source/build/venv}"/lib/python*/site-packages/nvidia)
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
tried=

nvcc=$(command -v nvcc || echo "$packages/cu13/bin/nvcc")
if [ -x "$nvcc" ]; then
  for unit in $units; do
    "$nvcc" -std=c++20 --expt-relaxed-constexpr -diag-suppress=20011,20014 -gencode arch=compute_80,code=sm_80 \
      -gencode arch=compute_90,code=sm_90 -I"$source/include" -c "$source/$unit" -o "$out/device.o"
    echo "nvcc, sm_80 and sm_90: $unit compiled"
  done
  tried=nvcc
fi

for clang in clang++-19 clang++-18 clang++-17 clang++-16; do command -v "$clang" >/dev/null && break; done
if command -v "$clang" >/dev/null && [ -d "$packages/cuda_runtime/include" ] && [ -d "$packages/cuda_nvcc/nvvm" ]; then
  mkdir -p "$out/cuda/include" # as a CUDA toolkit lies
  for part in cuda_runtime cuda_nvcc cuda_cccl; do
    [ ! -d "$packages/$part/include" ] || cp -rsf "$packages/$part/include/." "$out/cuda/include"
  done
  : >"$out/cuda/include/curand_mtgp32_kernel.h" # Clang includes it; no random numbers here
  ln -s "$packages/cuda_nvcc/nvvm" "$out/cuda/nvvm"
  ln -s "$packages/cuda_nvcc/bin" "$out/cuda/bin"
  for unit in $units; do
    least=4 # of the bench
    [ "${unit##*/}" != device.cu ] || least=11 # the table's, and of ten laws the formulas
    for arch in sm_80 sm_90; do
      "$clang" -std=c++20 --cuda-path="$out/cuda" --cuda-gpu-arch="$arch" --cuda-device-only -Wno-unknown-cuda-version -O2 \
        -I"$source/include" -x cuda -S "$source/$unit" -o "$out/device.ptx"
      kernels=$(grep -c '^\.visible \.entry\|^\.entry\|^\.weak \.entry' "$out/device.ptx")
      [ "$kernels" -ge "$least" ] || { echo "$unit, $arch: $kernels kernels only"; exit 1; }
      "$packages/cuda_nvcc/bin/ptxas" -arch="$arch" "$out/device.ptx" -o "$out/device.cubin"
      echo "$clang, $arch: $kernels kernels of $unit"
    done
  done
  tried="$tried clang"
fi
[ -n "$tried" ] || { echo "skipped: neither nvcc nor Clang 16 or later with NVIDIA's headers"; exit 77; }
