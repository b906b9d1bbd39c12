package sunbeam.app.scene.mesh;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Of a mesh that says that it encloses a body only the fronts are drawn: a triangle that is turned round would be a hole. */
class ClosedMeshTest {

    @ParameterizedTest
    @ValueSource(strings = {"snake", "sphere"})
    void everyEdgeIsPassedOnceEitherWay(String name) {
        Mesh mesh = BuiltInMeshes.create(name);
        assertThat(mesh.closed()).isTrue();
        int[] places = places(mesh);
        Map<List<Integer>, Integer> passed = new HashMap<>();
        for (int i = 0; i < mesh.indices().length; i += 3) {
            for (int k = 0; k < 3; k++) {
                int from = places[mesh.indices()[i + k]];
                int to = places[mesh.indices()[i + (k + 1) % 3]];
                // At the poles of a sphere a side may have no length.
                if (from != to) {
                    passed.merge(List.of(from, to), 1, Integer::sum);
                }
            }
        }
        assertThat(passed).hasSizeGreaterThan(1000);
        passed.forEach((edge, times) -> assertThat(passed.get(List.of(edge.get(1), edge.get(0))))
                .as("edge %s, passed %d times, the other way", edge, times)
                .isEqualTo(times));
    }

    /** One number for all vertices of one place: seams of the texture have two. */
    private static int[] places(Mesh mesh) {
        float[] positions = mesh.positions();
        Map<List<Long>, Integer> known = new HashMap<>();
        int[] places = new int[positions.length / 3];
        for (int i = 0; i < places.length; i++) {
            // A seam's two may differ by rounding, to 1e-6 of the size.
            List<Long> place = List.of(
                    Math.round(1e6 * positions[3 * i]),
                    Math.round(1e6 * positions[3 * i + 1]),
                    Math.round(1e6 * positions[3 * i + 2]));
            places[i] = known.computeIfAbsent(place, number -> known.size());
        }
        return places;
    }
}
