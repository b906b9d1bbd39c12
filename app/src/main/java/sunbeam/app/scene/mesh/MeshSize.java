package sunbeam.app.scene.mesh;

import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import sunbeam.app.scene.mesh.format.MeshUnit;
import sunbeam.precompute.units.Lengths;

/**
 * Check of a mesh's size. One smaller than {@link #LEAST} is hardly wider than the coherence area of sunlight (65 um), so that a pixel does
 * not average many such areas; one larger than {@link #MOST} has more than a centimeter in each of 1000 pixels, most likely a wrong unit.
 */
final class MeshSize {
    static final double LEAST = 100e-6;
    static final double MOST = 10;

    private MeshSize() {}

    /** Returns a warning about an implausible size. */
    static Optional<String> doubt(Mesh mesh, MeshUnit unit) {
        double side = longestSide(mesh);
        if (makesSense(side)) {
            return Optional.empty();
        }
        String remedy = Stream.of(MeshUnit.MM, MeshUnit.CM, MeshUnit.IN, MeshUnit.M, MeshUnit.UM)
                .filter(other -> makesSense(side / unit.metres() * other.metres()))
                .findFirst()
                .map(other -> other.name().toLowerCase(Locale.ROOT))
                .map(word -> "if its numbers are in " + word + ", give --mesh-unit " + word
                        + ", in a scene \"meshUnit\": \"" + word + "\"")
                .orElse("scale it");
        return Optional.of("the mesh is " + Lengths.rounded(side, 3) + " wide, where " + Lengths.format(LEAST) + " to "
                + Lengths.format(MOST) + " make sense; " + remedy);
    }

    private static boolean makesSense(double side) {
        return side >= LEAST && side <= MOST;
    }

    /** Longest side of the bounding box, meters. */
    private static double longestSide(Mesh mesh) {
        double longest = 0;
        for (int axis = 0; axis < 3; axis++) {
            double least = Double.POSITIVE_INFINITY;
            double most = Double.NEGATIVE_INFINITY;
            for (int i = axis; i < mesh.positions().length; i += 3) {
                least = Math.min(least, mesh.positions()[i]);
                most = Math.max(most, mesh.positions()[i]);
            }
            longest = Math.max(longest, most - least);
        }
        return longest;
    }
}
