#!/bin/bash
# The layers of Documentation/architecture.md, kept by a search.
set -euo pipefail
cd "$(dirname "$0")/.."
failed=0

# Algorithms are plain C++: in a Private folder only Core's bridges know VTK.
if grep -rnE '#include [<"]vtk' Filters/*/Private Rendering/Private |
  grep -vE '^Filters/Core/Private/(HintBridge|MeshBridge|SkeletonBridge|LabelBridge|FilterSupport|ParallelFor|VTKVersions)\.(h|cxx):'; then
  echo "VTK is included in the algorithm layer: see above." >&2
  failed=1
fi

# Backends do not show in public headers.
if grep -nE '#include [<"](Eigen|boost|CGAL)/' Filters/*/vtk*.h Rendering/vtk*.h; then
  echo "A public header includes a backend: see above." >&2
  failed=1
fi

# Marrow's private headers are not installed, so no public header may need them.
private=$(find Filters/*/Private Rendering/Private -name '*.h' -printf '%f\n' | paste -sd'|' |
  sed 's/\./\\./g')
if grep -nE "#include \"($private)\"" Filters/*/vtk*.h Rendering/vtk*.h; then
  echo "A public header includes a private one: see above." >&2
  failed=1
fi

# The differences between VTK's versions stand in one header.
if grep -rnE '^ *#.*VTK_(VERSION|MAJOR|MINOR)' --include='*.h' --include='*.cxx' \
  Filters Rendering Wrapping Examples Testing Documentation |
  grep -v '^Filters/Core/Private/VTKVersions.h:'; then
  echo "VTK's version is asked for outside of VTKVersions.h: see above." >&2
  failed=1
fi
exit $failed
