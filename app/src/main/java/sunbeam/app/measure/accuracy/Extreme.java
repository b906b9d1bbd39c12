package sunbeam.app.measure.accuracy;

import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Supplier;
import sunbeam.precompute.patch.HeightMap;

/**
 * A surface at the edge of what can be asked for.
 *
 * @param name in words
 * @param map makes the heights, which may be large
 * @param coherenceLengths windows to look at it by, metres
 */
record Extreme(String name, Supplier<HeightMap> map, List<Double> coherenceLengths) {
    private static final long SEED = 1;
    private static final double MICROMETRES_PER_METRE = 1e6;
    private static final double NANOMETRE = 1e-9;

    /** The slowest last: mirrors, faint and single things, gratings of few and many lines, thin and vast patches, deep relief, far scales. */
    static List<Extreme> all() {
        return List.of(
                of("mirror", () -> waves(64, 64, 100, 0), 1, 65, 1000),
                of("relief of 1 nm, rough", () -> rough(128, 128, 100, 1), 20),
                of("one step of 300 nm", () -> step(128, 80, 300), 5, 65),
                of("one grain of dust, 1 um wide, 200 nm high, on 25 um", () -> dust(128, 200, 200), 20),
                of("lamellar grating of 2 lines", () -> lamellar(64, 2), 65),
                of("lamellar grating of 20 lines", () -> lamellar(320, 20), 65),
                of("lamellar grating of 200 lines", () -> lamellar(3200, 200), 65, 200),
                of("1 x 127 samples, rough", () -> rough(1, 127, 80, 300), 20),
                of("127 x 1 samples, rough", () -> rough(127, 1, 80, 300), 20),
                of("4096 x 1 samples, rough", () -> rough(4096, 1, 20, 300), 65),
                of("1024 x 1024 samples, rough", () -> rough(1024, 1024, 50, 300), 30),
                of("relief of 5 um, rough", () -> rough(256, 256, 200, 5000), 30),
                of("relief of 5 um, one slope", () -> slope(128, 200, 5000), 30),
                of("side of 0.3 um, waves", () -> waves(16, 16, 300.0 / 16, 100), 1, 65),
                of("sides of 5 mm by 78 um, rough", () -> rough(4096, 64, 1220, 400), 100, 1000),
                of("rough, window from short to long", () -> rough(256, 256, 50, 400), 1, 10, 100, 1000),
                of("4096 x 4096 samples, rough", () -> rough(4096, 4096, 20, 300), 30));
    }

    private static Extreme of(String name, Supplier<HeightMap> map, double... coherenceLengthsMicrometres) {
        return new Extreme(
                name,
                map,
                Arrays.stream(coherenceLengthsMicrometres)
                        .map(length -> length / MICROMETRES_PER_METRE)
                        .boxed()
                        .toList());
    }

    private static HeightMap rough(int columns, int rows, double pitchNanometres, double reliefNanometres) {
        SplittableRandom random = new SplittableRandom(SEED);
        double pitch = pitchNanometres * NANOMETRE;
        HeightMap smooth =
                RandomSurface.smoothed(RandomSurface.of(columns, rows, pitch, pitch, (x, y) -> random.nextDouble()), 3);
        double scale = reliefNanometres * NANOMETRE / smooth.relief();
        return smooth.map(height -> height * scale);
    }

    private static HeightMap waves(int columns, int rows, double pitchNanometres, double reliefNanometres) {
        double pitch = pitchNanometres * NANOMETRE;
        double amplitude = 0.25 * reliefNanometres * NANOMETRE;
        return RandomSurface.of(
                columns,
                rows,
                pitch,
                pitch,
                (x, y) -> amplitude * (Math.sin(2 * Math.PI * x) + Math.cos(2 * Math.PI * y)));
    }

    private static HeightMap step(int side, double pitchNanometres, double reliefNanometres) {
        double pitch = pitchNanometres * NANOMETRE;
        return RandomSurface.of(side, side, pitch, pitch, (x, y) -> x < 0.5 ? reliefNanometres * NANOMETRE : 0);
    }

    private static HeightMap dust(int side, double pitchNanometres, double reliefNanometres) {
        double pitch = pitchNanometres * NANOMETRE;
        double radius = 0.5 / MICROMETRES_PER_METRE / (side * pitch);
        return RandomSurface.of(
                side,
                side,
                pitch,
                pitch,
                (x, y) -> Math.hypot(x - 0.5, y - 0.5) < radius ? reliefNanometres * NANOMETRE : 0);
    }

    /** Lines of 1 um or less, half as wide, 200 nm high. */
    private static HeightMap lamellar(int columns, int lines) {
        double pitch = 50 * NANOMETRE;
        return RandomSurface.of(columns, 1, pitch, pitch, (x, y) -> lines * x % 1 < 0.5 ? 200 * NANOMETRE : 0);
    }

    private static HeightMap slope(int side, double pitchNanometres, double reliefNanometres) {
        double pitch = pitchNanometres * NANOMETRE;
        return RandomSurface.of(side, side, pitch, pitch, (x, y) -> x * reliefNanometres * NANOMETRE);
    }
}
