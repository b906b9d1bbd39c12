"""Reads the parts that `sunbeam sample` wrote (.npz or .h5) as one: python3 read_samples.py rows-*.npz"""
import sys
import numpy as np

def read(path):
    if path.endswith(".npz"):
        with np.load(path) as file:
            return {name: file[name] for name in file if name != "metadata.json"}
    import h5py
    with h5py.File(path) as file:
        return {name: file[name][:] for name in file}

if len(sys.argv) < 2:
    sys.exit(__doc__)
parts = [read(path) for path in sorted(sys.argv[1:], key=lambda path: (len(path), path))]
rows = {name: np.concatenate([part[name] for part in parts]) for name in parts[0]}
cosines = (rows["light"][:, 2] * rows["view"][:, 2]).astype(float)
print({name: array.shape for name, array in rows.items()}, "integral of the cosines by pi^2:",
      (cosines / rows["density"]).mean() / np.pi ** 2)
