package sunbeam.app.scene.mesh;

import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import sunbeam.app.scene.mesh.format.MeshUnit;
import sunbeam.precompute.units.Lengths;

/**
 * Checks the longest side of a mesh's bounding box, in meters. A mesh smaller than {@link #LEAST} is hardly wider than the coherence area
 * of sunlight (65 um), so that a pixel does not average many such areas. A mesh larger than {@link #MOST} has more than a centimeter per
 * pixel in a picture 1000 pixels wide; its unit is most likely wrong.
 */
final class MeshSize {
    /** Meters. */
    static final double LEAST = 100e-6;

    /** Meters. */
    static final double MOST = 10;

    private MeshSize() {}

    static Optional<String> warning(Mesh mesh, MeshUnit unit) {
        double side = longestSide(mesh);
        if (isPlausible(side)) {
            return Optional.empty();
        }
        String remedy = Stream.of(MeshUnit.MM, MeshUnit.CM, MeshUnit.IN, MeshUnit.M, MeshUnit.UM)
                .filter(other -> isPlausible(side / unit.meters() * other.meters()))
                .findFirst()
                .map(other -> other.name().toLowerCase(Locale.ROOT))
                .map(word -> "if its numbers are in " + word + ", give --mesh-unit " + word
                        + ", in a scene \"meshUnit\": \"" + word + "\"")
                .orElse("scale it");
        return Optional.of("the mesh is " + Lengths.rounded(side, 3) + " wide, where " + Lengths.format(LEAST) + " to "
                + Lengths.format(MOST) + " make sense; " + remedy);
    }

    private static boolean isPlausible(double side) {
        return side >= LEAST && side <= MOST;
    }

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
