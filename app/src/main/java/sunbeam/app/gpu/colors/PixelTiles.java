package sunbeam.app.gpu.colors;

import java.util.List;
import java.util.function.IntUnaryOperator;
import java.util.stream.IntStream;
import sunbeam.precompute.colortable.TableSpace;
import sunbeam.precompute.colortable.TileFeedback;
import sunbeam.precompute.colortable.TileGrid;

/** Which tiles pixels look into. */
final class PixelTiles {
    private static final int CHANNELS = 4;
    // Pixels whose tiles are found by one processor at a time: about a millisecond's work.
    private static final int TOGETHER = 1 << 10;

    private PixelTiles() {}

    /** Finds them; parameters as of {@link LevelTiles#note}. */
    static TileSet of(
            List<TileGrid> grids, float[] places, float[] wide, float[] narrow, int count, IntUnaryOperator at) {
        TileSet all = TileSet.none(grids.size());
        IntStream.range(0, (count + TOGETHER - 1) / TOGETHER)
                .parallel()
                .mapToObj(part -> {
                    TileSet some = TileSet.none(grids.size());
                    List<TileFeedback> marks = IntStream.range(0, grids.size())
                            .mapToObj(level -> new TileFeedback(grids.get(level), some.of(level)))
                            .toList();
                    int end = Math.min(count, (part + 1) * TOGETHER);
                    for (int i = part * TOGETHER; i < end; i++) {
                        note(places, wide, narrow, at.applyAsInt(i), marks);
                    }
                    return some;
                })
                .forEachOrdered(all::add);
        return all;
    }

    private static void note(float[] places, float[] wide, float[] narrow, int at, List<TileFeedback> marks) {
        int level = (int) places[at + 3];
        if (level < 0) {
            return;
        }
        int columns = (int) wide[at + 3];
        int rows = (int) narrow[at + 3];
        double across = 0.5 - 0.5 / columns;
        double along = 0.5 - 0.5 / rows;
        double[] uvw = new double[CHANNELS - 1];
        double[] half = new double[uvw.length];
        double farthest = 0;
        for (int axis = 0; axis < uvw.length; axis++) {
            half[axis] = across * Math.abs(wide[at + axis]) + along * Math.abs(narrow[at + axis]);
            farthest = Math.hypot(farthest, Math.abs(places[at + axis]) + half[axis]);
        }
        boolean marked = farthest <= TableSpace.AllLights.REACH
                && marks.get(level).markAll(places[at], places[at + 1], places[at + 2], half[0], half[1], half[2]);
        if (marked) {
            return;
        }
        for (int i = 0; i < columns; i++) {
            for (int j = 0; j < rows; j++) {
                for (int axis = 0; axis < uvw.length; axis++) {
                    uvw[axis] = places[at + axis]
                            + ((i + 0.5) / columns - 0.5) * wide[at + axis]
                            + ((j + 0.5) / rows - 0.5) * narrow[at + axis];
                }
                TableSpace.AllLights.within(uvw);
                marks.get(level).mark(uvw[0], uvw[1], uvw[2]);
            }
        }
    }
}
