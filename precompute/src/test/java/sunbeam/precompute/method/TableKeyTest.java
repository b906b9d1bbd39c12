package sunbeam.precompute.method;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.builtin.BuiltInPatches;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.shader.ShaderTables.MethodUse;

/** What determines a table of colors. */
class TableKeyTest {
    private static final TableMethod METHOD = new TableMethod(1e-2, GaussianArea.STANDARD);

    private static String key(List<DirectionPair> pairs) {
        HeightMap map = BuiltInPatches.generate("blaze");
        Surface surface = new Surface(map, "blaze", "digest", CieTable.load());
        return METHOD.plan(surface, VisibleRange.of(pairs)).key(MethodUse.COLOR);
    }

    private static List<DirectionPair> pairs(double middle) {
        Direction light = new Direction(0, 0, 1);
        return List.of(
                new DirectionPair(light, Direction.ofDegrees(40, 0)),
                new DirectionPair(light, Direction.ofDegrees(middle, 200)),
                new DirectionPair(light, Direction.ofDegrees(40, 180)),
                new DirectionPair(light, Direction.ofDegrees(40, 90)),
                new DirectionPair(light, Direction.ofDegrees(40, 270)));
    }

    /** Both use texels of the coarsest table, but refined tables contain only one list's tiles. */
    @Test
    void listsThatDifferByLessThanATexelHaveTablesOfTheirOwn() {
        assertThat(key(pairs(20))).isEqualTo(key(pairs(20))).isNotEqualTo(key(pairs(20.001)));
    }
}
