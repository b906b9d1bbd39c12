package sunbeam.precompute.rays;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.ForkJoinTask;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import java.util.function.LongConsumer;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import sunbeam.precompute.colortable.ColorColumns;
import sunbeam.precompute.colortable.ColorSource;
import sunbeam.precompute.colortable.TableSpace;
import sunbeam.precompute.plan.GaussianArea;

/**
 * Colors of the ensemble average at many (u, v) in few slices of w: evaluated along rays through the origin, for all
 * wavelengths and places at once ({@link RayConvolution}), and interpolated between them by quintic B-splines through
 * square roots, which err by a tenth of what cubic splines between the places that are asked for will (docs/color-tables.md).
 *
 * <p>The disc is divided into octaves of |(u, v)|, so that no more rays go inwards than are needed there, and octaves into
 * sectors, of which only those are evaluated that are asked for. Safe for use by several threads.
 */
public final class RayColors implements ColorSource {
    // Within so many steps of the origin directions are evaluated one by one.
    private static final double INNER_STEPS = 5;
    // Of rays and of places on them, in steps of the table: quintic splines err by less there than cubic ones do at
    // one.
    private static final double SPACING = 1.1;
    // Of what is prepared for slices; that of deep reliefs, which takes more, is made anew for each call.
    private static final long MOST_KEPT_BYTES = 1 << 26;
    // Columns whose sectors one processor finds at a time.
    private static final int TOGETHER = 1 << 12;
    // exp(-reach^2) of a bin is left out: 1e-10 of it in the finest table, beside which a wing of 1e-6 stays right,
    // 2e-5 in
    // averages for pixels.
    private static final double FINE_REACH = 4.8;
    private static final double COARSE_REACH = 3.3;

    private final RaySpectrum spectrum;
    private final WindowedPowers powers;
    private final double sigmaFrequency;
    private final double step;
    private final double sliceStep;
    private final double farthest;
    private final LongConsumer progress;
    // Guarded by this.
    private List<RayOctave> octaves = List.of();
    // Guarded by this.
    private Prepared prepared = new Prepared(new double[0], List.of(), List.of());

    /** Colors of all directions; parameters as of the other constructor. */
    public RayColors(
            RaySpectrum spectrum,
            GaussianArea area,
            double step,
            double sliceStep,
            boolean fine,
            LongConsumer progress) {
        this(spectrum, area, step, sliceStep, TableSpace.AllLights.REACH, fine, progress);
    }

    /**
     * Colors under a window.
     *
     * @param step of (u, v) between the places that will be asked for
     * @param sliceStep of w, between slices that four at a time suffice to interpolate
     * @param farthest |(u, v)| that will be asked for; rays are as close there as the step says
     * @param fine whether wings of bright orders matter
     * @param progress told how many places have been evaluated since it was told last, which may be none, every few milliseconds,
     *     by any thread; what it throws ends the evaluation
     */
    public RayColors(
            RaySpectrum spectrum,
            GaussianArea area,
            double step,
            double sliceStep,
            double farthest,
            boolean fine,
            LongConsumer progress) {
        this.spectrum = spectrum;
        this.powers = spectrum.under(area, fine ? FINE_REACH : COARSE_REACH, !fine);
        this.sigmaFrequency = area.window().sigmaFrequency();
        this.step = SPACING * step;
        this.sliceStep = sliceStep;
        this.farthest = farthest;
        this.progress = progress;
    }

    @Override
    public float[] xyz(float[] places) {
        float[] xyz = new float[places.length];
        List<RaySector.Places> sectors = sectors(PlaceColumns.throughAll(places, sliceStep));
        runAll(sectors, sector -> {
            float[] some = sector.of(places);
            sector.put(sector.isInMiddle() ? direct().xyz(some) : alongRays(sector, some), xyz);
            progress.accept(sector.count());
        });
        return xyz;
    }

    /** Of one sector, with slices of its own. */
    private float[] alongRays(RaySector.Places sector, float[] places) {
        PlaceColumns columns = PlaceColumns.of(places, sliceStep);
        double[] depths = columns.depths();
        new RaySector(powers, sector, sector.octave().convolution(depths), () -> progress.accept(0))
                .evaluate(
                        columns,
                        IntStream.range(0, sector.count()).toArray(),
                        IntStream.range(0, depths.length).toArray());
        return columns.xyz();
    }

    /** As {@link #xyz}, so that the color of a place does not depend on which others are asked for with it. */
    public float[] independentXyz(float[] places) {
        PlaceColumns columns = PlaceColumns.throughAll(places, sliceStep);
        evaluate(columns, evaluated -> progress.accept(evaluated / PlaceColumns.TAPS));
        return columns.xyz();
    }

    @Override
    public float[] exact(float[] places) {
        float[] xyz = direct().xyz(places);
        progress.accept(places.length / 3);
        return xyz;
    }

    private DirectColors direct() {
        return new DirectColors(spectrum, powers, sigmaFrequency);
    }

    @Override
    public void evaluate(ColorColumns columns) {
        evaluate(columns, progress);
    }

    private void evaluate(ColorColumns columns, LongConsumer evaluated) {
        double[] depths = columns.depths();
        if (depths.length == 0) {
            return;
        }
        Prepared ready = prepared(depths);
        int[] slices = Arrays.stream(depths)
                .mapToInt(depth -> Arrays.binarySearch(ready.depths(), depth))
                .toArray();
        runAll(
                sectors(columns),
                sector -> evaluated.accept(
                        sector.isInMiddle()
                                ? direct().evaluate(sector.numbers(), columns)
                                : new RaySector(powers, sector, ready.of(sector.octave()), () -> progress.accept(0))
                                        .evaluate(columns, sector.numbers(), slices)));
    }

    /** Beside each other; if one fails, none is going on any more when its failure is thrown. */
    private static void runAll(List<RaySector.Places> sectors, Consumer<RaySector.Places> work) {
        AtomicReference<RuntimeException> failure = new AtomicReference<>();
        // One by one, and not in halves as streams are: those of outer octaves take longest.
        ForkJoinTask.invokeAll(sectors.stream()
                .map(sector -> ForkJoinTask.adapt(() -> {
                    try {
                        if (failure.get() == null) {
                            work.accept(sector);
                        }
                    } catch (RuntimeException problem) {
                        failure.compareAndSet(null, problem);
                    }
                }))
                .toList());
        if (failure.get() != null) {
            throw failure.get();
        }
    }

    /** The columns in which anything is asked for, by sectors that have some. */
    private List<RaySector.Places> sectors(ColorColumns columns) {
        List<RayOctave> all = octaves();
        List<RaySector.Places> sectors = new ArrayList<>();
        int[] before = new int[all.size() + 1];
        for (int i = 0; i < all.size(); i++) {
            RayOctave octave = all.get(i);
            IntStream.range(0, octave.sectors()).forEach(sector -> sectors.add(new RaySector.Places(octave, sector)));
            before[i + 1] = sectors.size();
        }
        sectors.add(new RaySector.Places(null, 0));
        int[] numbers = sectors(columns, all, before);
        for (int i = 0; i < numbers.length; i++) {
            if (numbers[i] >= 0) {
                sectors.get(numbers[i]).add(i);
            }
        }
        sectors.removeIf(sector -> sector.count() == 0);
        return sectors;
    }

    /**
     * The number of each column's sector; -1 where nothing is asked for.
     *
     * @param before numbers of the sectors before each octave's, and of the middle
     */
    private static int[] sectors(ColorColumns columns, List<RayOctave> octaves, int[] before) {
        int[] numbers = new int[columns.count()];
        int parts = (numbers.length + TOGETHER - 1) / TOGETHER;
        int slices = columns.depths().length;
        IntStream.range(0, parts).parallel().forEach(part -> {
            float[] uv = new float[2];
            int[] some = new int[slices];
            int end = Math.min(numbers.length, (part + 1) * TOGETHER);
            for (int column = part * TOGETHER; column < end; column++) {
                numbers[column] = -1;
                if (columns.asked(column, some) > 0) {
                    columns.locate(column, uv);
                    numbers[column] = sector(uv[0], uv[1], octaves, before);
                }
            }
        });
        return numbers;
    }

    /** @param before numbers of the sectors before each octave's */
    private static int sector(double u, double v, List<RayOctave> octaves, int[] before) {
        double radius = Math.sqrt(u * u + v * v);
        int octave = 0;
        while (octave < octaves.size() && radius < octaves.get(octave).low()) {
            octave++;
        }
        return before[octave] + (octave < octaves.size() ? octaves.get(octave).sector(u, v) : 0);
    }

    /** Those of earlier calls, or new ones. */
    private synchronized List<RayOctave> octaves() {
        if (octaves.isEmpty()) {
            int last = (int) Math.max(0, Math.log(farthest / (2 * INNER_STEPS * step)) / Math.log(2));
            octaves = IntStream.rangeClosed(0, last)
                    .parallel()
                    .mapToObj(number -> new RayOctave(spectrum, sigmaFrequency, farthest / (1 << number), step))
                    .toList();
        }
        return octaves;
    }

    /** Convolutions of octaves, and |w| of the slices that they were prepared for, ascending. */
    private record Prepared(double[] depths, List<RayOctave> octaves, List<RayConvolution> convolutions) {
        RayConvolution of(RayOctave octave) {
            return convolutions.get(octaves.indexOf(octave));
        }
    }

    /** Those of earlier calls, if they have all slices; else new ones for theirs and these. */
    private synchronized Prepared prepared(double[] depths) {
        double[] known = prepared.depths();
        if (!Arrays.stream(depths).allMatch(depth -> Arrays.binarySearch(known, depth) >= 0)) {
            double[] all = DoubleStream.concat(Arrays.stream(known), Arrays.stream(depths))
                    .sorted()
                    .distinct()
                    .toArray();
            List<RayConvolution> convolutions = octaves().parallelStream()
                    .map(octave -> {
                        // Each takes some ten milliseconds.
                        progress.accept(0);
                        return octave.convolution(all);
                    })
                    .toList();
            Prepared made = new Prepared(all, octaves(), convolutions);
            if (convolutions.stream().mapToLong(RayConvolution::bytes).sum() > MOST_KEPT_BYTES) {
                return made;
            }
            prepared = made;
        }
        return prepared;
    }
}
