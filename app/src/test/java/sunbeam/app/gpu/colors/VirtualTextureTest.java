package sunbeam.app.gpu.colors;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.BitSet;
import java.util.Deque;
import java.util.Iterator;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.CancellationException;
import java.util.stream.Stream;
import jrtr.gl.RenderContext;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import sunbeam.app.gpu.NeedsDisplay;
import sunbeam.app.render.InAScene;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.viewer.ViewerInAWindow;
import sunbeam.app.work.CancellationToken;
import sunbeam.precompute.colortable.AtlasPages;
import sunbeam.precompute.colortable.AtlasPages.TableLookUp;
import sunbeam.precompute.colortable.ColorTable;
import sunbeam.precompute.colortable.Interpolation;
import sunbeam.precompute.colortable.LevelBaking;
import sunbeam.precompute.colortable.NumberFormat;
import sunbeam.precompute.colortable.TableDesign;
import sunbeam.precompute.colortable.TileGrid;
import sunbeam.precompute.colortable.ValidatedTable;
import sunbeam.precompute.errors.ErrorStatistics;
import sunbeam.precompute.method.LevelBakers;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.TableMethod;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.ShaderTables;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.work.Progress;

/** A color table whose tiles are baked and one whose tiles are in the cache; the look-ups of shader and Java agree. */
@NeedsDisplay
class VirtualTextureTest {
    @TempDir
    private Path folder;

    @Test
    void onlyBakedTilesAreValidatedNotTilesFromTheCache() {
        try (CachedBaker baking = new CachedBaker(bakers())) {
            bakeCoarsest(baking);
            // Validation evaluates colors, which a canceled token ends at once.
            assertThatThrownBy(() -> validate(baking)).isInstanceOf(CancellationException.class);
        }
        try (CachedBaker reading = new CachedBaker(bakers())) {
            bakeCoarsest(reading);
            // A BRDF map bakes points.
            assertThat(reading.bakePoints(new float[] {0, 0, -1.9f}, new CancellationToken()))
                    .hasSize(3);
            validate(reading);
        }
    }

    @Test
    void aTableInTheCacheIsRequestedWithoutFootprints() {
        assertThat(isRequestedWhole()).as("before any tile is baked").isFalse();
        try (CachedBaker baking = new CachedBaker(bakers())) {
            baking.bakeAll(CachedBaker.PrefetchSet.of(baking.grids()).prefetched());
        }
        assertThat(isRequestedWhole()).isTrue();
    }

    /** Starts a background table; if its whole is requested, checks that all tiles arrive. */
    private boolean isRequestedWhole() {
        Deque<Runnable> tasks = new ArrayDeque<>();
        boolean isWhole;
        try (RenderContext context = RenderContext.offscreen();
                VirtualTexture texture = new VirtualTexture(context, bakers())) {
            texture.bakeOn(tasks::add, () -> {});
            tasks.remove().run();
            isWhole = texture.requestWhole(false);
            runAll(tasks);
            assertThat(texture.drain()).isTrue();
            assertThat(texture.isComplete()).isEqualTo(isWhole);
        }
        runAll(tasks);
        return isWhole;
    }

    private static void runAll(Deque<Runnable> tasks) {
        while (!tasks.isEmpty()) {
            tasks.remove().run();
        }
    }

    private LevelBakers bakers() {
        Scene scene = ViewerInAWindow.scene()
                .with(Choices.none()
                        .with(Methods.METHOD, TableMethod.TYPE)
                        .with(SceneSettings.ROUGHNESS, Math.toRadians(4)));
        return InAScene.parts(scene, folder).get(0).bakers().orElseThrow();
    }

    private static void bakeCoarsest(CachedBaker baker) {
        TileSet coarsest = CachedBaker.PrefetchSet.of(baker.grids()).coarsest();
        assertThat(coarsest.isEmpty()).isFalse();
        baker.bakeAll(coarsest);
    }

    private static void validate(CachedBaker baker) {
        int coarsest = baker.grids().size() - 1;
        double[] white = {1, 1, 1};
        Footprints.Tabulated footprint = new Footprints.Tabulated(coarsest, new double[][] {{0, 0, -1.9}}, white);
        CancellationToken canceled = new CancellationToken();
        canceled.cancel();
        baker.validate(List.of(footprint), canceled);
    }

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
                    .bake(tiles, (uvw, token) -> waves(uvw), Progress.NONE)
                    .iterator();
            tiles.stream().forEach(tile -> cells.add(0, tile, made.next()));
            ShaderTables.Builder tables = new ShaderTables.Builder("table");
            new ValidatedTable(cells, ErrorStatistics.of()).putInto(tables);
            float[] places = places(1000);
            float[] shown;
            try (GpuBaker colors = GpuBaker.of(tables.build(1e-5, 0.1))) {
                shown = colors.bake(places, Progress.NONE);
            }
            TableLookUp table = cells.lookUp();
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
