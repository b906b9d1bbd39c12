package sunbeam.app.gpu.colors;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.BitSet;
import java.util.Iterator;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import sunbeam.app.gpu.NeedsDisplay;
import sunbeam.precompute.colortable.AtlasPages;
import sunbeam.precompute.colortable.ColorBaker;
import sunbeam.precompute.colortable.ColorTable;
import sunbeam.precompute.colortable.Interpolation;
import sunbeam.precompute.colortable.LevelBaking;
import sunbeam.precompute.colortable.NumberFormat;
import sunbeam.precompute.colortable.TableDesign;
import sunbeam.precompute.colortable.TableLookUp;
import sunbeam.precompute.colortable.TileGrid;
import sunbeam.precompute.colortable.ValidatedTable;
import sunbeam.precompute.errors.ErrorStatistics;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.shader.ShaderTables;

/** The look-ups of shader and Java agree. */
@NeedsDisplay
class ColorTableShaderTest {
    private static final Direction LIGHT = Direction.ofDegrees(30, 20);
    private static final TableDesign DESIGN = new TableDesign(0.04, 9);

    static Stream<TileGrid> grids() {
        return Stream.of(
                TileGrid.of(DESIGN, LIGHT),
                TileGrid.of(new ColorTable.Level(GaussianArea.STANDARD, 1, DESIGN, Interpolation.CUBIC, true)),
                TileGrid.of(new ColorTable.Level(GaussianArea.STANDARD, 1, DESIGN, Interpolation.SHIFTED_LINES, true)));
    }

    /** A few texels to a wave, so that filters differ, and slices do. */
    private static float[] waves(float[] uvw) {
        float[] xyz = new float[uvw.length];
        for (int i = 0; i < uvw.length; i++) {
            int at = i / 3 * 3;
            xyz[i] = (float) Math.pow(1.5 + i % 3 + Math.sin(40 * uvw[at] + 30 * uvw[at + 1]) + uvw[at + 2], 2);
        }
        return xyz;
    }

    @ParameterizedTest
    @MethodSource("grids")
    void colorsInTheShaderAreThoseInJava(TileGrid grid) {
        for (NumberFormat numbers : NumberFormat.values()) {
            AtlasPages cells = new AtlasPages(List.of(grid), numbers);
            BitSet tiles = grid.reachable();
            Iterator<byte[]> made = new LevelBaking(grid, numbers)
                    .bake(tiles, (uvw, token) -> waves(uvw), ColorBaker.Token.NONE)
                    .iterator();
            tiles.stream().forEach(tile -> cells.add(0, tile, made.next()));
            ShaderTables.Builder tables = new ShaderTables.Builder("table");
            new ValidatedTable(grid, numbers, cells, ErrorStatistics.of()).putInto(tables);
            float[] places = places(1000);
            float[] shown;
            try (GpuBaker colors = GpuBaker.of(tables.build(1e-5, 0.1))) {
                shown = colors.bake(places, ColorBaker.Token.NONE);
            }
            TableLookUp table = new TableLookUp(List.of(grid), numbers, cells::coefficient);
            for (int i = 0; i < shown.length; i += 3) {
                double[] xyz = table.xyz(0, places[i], places[i + 1], places[i + 2]);
                for (int c = 0; c < 3; c++) {
                    // Positions are rounded to 1/8192 of a texel, over which colors change by their own size; float32.
                    assertThat((double) shown[i + c]).isCloseTo(xyz[c], within(3e-4 * (1 + xyz[c])));
                }
            }
        }
    }

    private static float[] places(int count) {
        SplittableRandom random = new SplittableRandom(4);
        float[] places = new float[3 * count];
        for (int i = 0; i < count; i++) {
            double z = random.nextDouble();
            double phi = random.nextDouble(2 * Math.PI);
            double sine = Math.sqrt(1 - z * z);
            DirectionPair pair = new DirectionPair(LIGHT, new Direction(sine * Math.cos(phi), sine * Math.sin(phi), z));
            places[3 * i] = (float) pair.u();
            places[3 * i + 1] = (float) pair.v();
            places[3 * i + 2] = (float) pair.w();
        }
        return places;
    }
}
