package sunbeam.precompute.rays;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.ForkJoinTask;
import java.util.function.LongConsumer;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import sunbeam.precompute.colourtable.ColourSource;
import sunbeam.precompute.plan.GaussianArea;

/**
 * Colours of the ensemble average at many (u, v) in few slices of w: evaluated along rays through the origin, for all
 * wavelengths and places at once ({@link RayConvolution}), and interpolated between them by quintic B-splines through
 * square roots, which err by a tenth of what cubic splines between the places that are asked for will (docs/colour-tables.md).
 *
 * <p>The disc is divided into octaves of |(u, v)|, so that no more rays go inwards than are needed there, and octaves into
 * sectors, of which only those are evaluated that are asked for. Safe for use by several threads.
 */
public final class RayColours implements ColourSource {
    private static final double FARTHEST = 2;
    // Within so many steps of the origin directions are evaluated one by one.
    private static final double INNER_STEPS = 5;
    // Of rays and of places on them, in steps of the table: quintic splines err by less there than cubic ones do at
    // one.
    private static final double SPACING = 1.1;
    private static final int MOST_SLICES = 2048;
    // Of what is prepared for slices; that of deep reliefs, which takes more, is made anew for each call.
    private static final long MOST_KEPT_BYTES = 1 << 26;
    private static final int CHANNELS = 3;
    // Places whose sectors one processor finds at a time.
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
    private final LongConsumer progress;
    // Guarded by this.
    private Prepared prepared = new Prepared(new double[0], List.of());

    /**
     * Colours under a window.
     *
     * @param step of (u, v) between the places that will be asked for
     * @param fine whether wings of bright orders matter
     * @param progress told how many places have been evaluated since it was told last, which may be none, every few milliseconds;
     *     by any thread, which goes on when it returns: whoever waits there holds up the others' work as well
     */
    public RayColours(RaySpectrum spectrum, GaussianArea area, double step, boolean fine, LongConsumer progress) {
        this.spectrum = spectrum;
        this.powers = spectrum.under(area, fine ? FINE_REACH : COARSE_REACH, !fine);
        this.sigmaFrequency = area.window().sigmaFrequency();
        this.step = SPACING * step;
        this.progress = progress;
    }

    /**
     * @throws IllegalArgumentException if places have more different w than slices are meant
     */
    @Override
    public float[] xyz(float[] places) {
        if (places.length == 0) {
            return new float[0];
        }
        Prepared ready = prepared(depths(places));
        double[] depths = ready.depths();
        List<RayOctave> octaves = ready.octaves();
        List<RaySector.Places> sectors = new ArrayList<>();
        for (RayOctave octave : octaves) {
            IntStream.range(0, octave.sectors()).forEach(sector -> sectors.add(new RaySector.Places(octave, sector)));
        }
        RaySector.Places direct = new RaySector.Places(null, 0);
        sectors.add(direct);
        int[] sector = sectors(places, octaves);
        for (int i = 0; i < sector.length; i++) {
            sectors.get(sector[i]).add(i);
        }
        float[] xyz = new float[places.length];
        List<ForkJoinTask<?>> tasks = new ArrayList<>();
        for (RaySector.Places some : sectors) {
            if (some != direct && !some.isEmpty()) {
                tasks.add(ForkJoinTask.adapt(() -> {
                    new RaySector(powers, some, () -> progress.accept(0)).evaluate(places, depths, xyz);
                    progress.accept(some.count());
                }));
            }
        }
        // One by one, and not in halves as streams are: those of outer octaves take longest.
        ForkJoinTask.invokeAll(tasks);
        new DirectColours(spectrum, powers).evaluate(direct, places, depths, xyz);
        progress.accept(direct.count());
        return xyz;
    }

    /** The number of each place's sector, octave after octave; behind the last one that of the places in the middle. */
    private static int[] sectors(float[] places, List<RayOctave> octaves) {
        int[] before = new int[octaves.size() + 1];
        for (int i = 0; i < octaves.size(); i++) {
            before[i + 1] = before[i] + octaves.get(i).sectors();
        }
        int[] numbers = new int[places.length / CHANNELS];
        int parts = (numbers.length + TOGETHER - 1) / TOGETHER;
        IntStream.range(0, parts).parallel().forEach(part -> {
            int first = part * TOGETHER;
            int end = Math.min(numbers.length, first + TOGETHER);
            for (int i = first; i < end; i++) {
                // Slices of one (u, v) follow each other.
                numbers[i] = i > first && RaySector.isBeside(places, CHANNELS * i, CHANNELS * (i - 1))
                        ? numbers[i - 1]
                        : sector(places[CHANNELS * i], places[CHANNELS * i + 1], octaves, before);
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

    /** Octaves, and |w| of the slices that they were prepared for, ascending. */
    private record Prepared(double[] depths, List<RayOctave> octaves) {}

    /** Those of earlier calls, if they have all slices; else new ones for theirs and these. */
    private synchronized Prepared prepared(double[] depths) {
        double[] known = prepared.depths();
        if (!Arrays.stream(depths).allMatch(depth -> Arrays.binarySearch(known, depth) >= 0)) {
            double[] all = DoubleStream.concat(Arrays.stream(known), Arrays.stream(depths))
                    .sorted()
                    .distinct()
                    .toArray();
            int last = (int) Math.max(0, Math.log(FARTHEST / (2 * INNER_STEPS * step)) / Math.log(2));
            List<RayOctave> octaves = IntStream.rangeClosed(0, last)
                    .parallel()
                    .mapToObj(number -> {
                        // Each takes some ten milliseconds.
                        progress.accept(0);
                        return new RayOctave(spectrum, sigmaFrequency, FARTHEST / (1 << number), step, all);
                    })
                    .toList();
            Prepared made = new Prepared(all, octaves);
            if (octaves.stream()
                            .mapToLong(octave -> octave.convolution().bytes())
                            .sum()
                    > MOST_KEPT_BYTES) {
                return made;
            }
            prepared = made;
        }
        return prepared;
    }

    /** |w| of all places, ascending. */
    private static double[] depths(float[] places) {
        double[] found = new double[MOST_SLICES];
        int count = 0;
        for (int i = 2; i < places.length; i += CHANNELS) {
            double depth = Math.abs(places[i]);
            int at = Arrays.binarySearch(found, 0, count, depth);
            if (at < 0) {
                if (count == MOST_SLICES) {
                    throw new IllegalArgumentException("places lie in more than " + MOST_SLICES + " slices of w");
                }
                System.arraycopy(found, -at - 1, found, -at, count + at + 1);
                found[-at - 1] = depth;
                count++;
            }
        }
        return Arrays.copyOf(found, count);
    }
}
