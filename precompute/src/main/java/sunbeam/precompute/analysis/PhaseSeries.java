package sunbeam.precompute.analysis;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import sunbeam.precompute.patch.HeightMap;

/**
 * A wave's phase against an exact grating's, followed across a patch: local amplitudes at equal steps along the wave's
 * direction, in strips beside each other. From one place to the next the phase turns by what the amplitudes of all
 * strips say: added up where they are in step, as those of one straight grating are; by the mean of their turns (pulse
 * pairs) where each strip of a grown surface has its own phase.
 *
 * @param step metres between places
 * @param phases radians; the first is 0
 * @param strengths amplitude at each place, metres
 * @param straight amplitudes of all strips together, complex, {@code [place][re, im]}, metres
 * @param straightness 0..1: how much of the strips' amplitudes is in step
 * @param bend by how much lines that bend are closer than along their mean direction, relative: half the mean square of
 *     their angle to it, of those that bend alike at all places
 * @param window length of the window around each place, in places
 */
record PhaseSeries(
        double step,
        double[] phases,
        double[] strengths,
        double[][] straight,
        double straightness,
        double bend,
        double window) {

    // Windows along the wave, in periods: with whole numbers constant, mirror frequency and overtones cancel. Three
    // leave less of what lies beside; few periods need the shorter.
    private static final int LONG = 3;
    private static final int SHORT = 2;
    private static final double ENOUGH_FOR_LONG = 9;
    private static final double ENOUGH_FOR_WHOLE_STEPS = 12;
    // Width of a strip in periods: wide enough to average noise, narrow enough for rows of a grown surface.
    private static final double STRIP = 4;
    private static final int MOST_STRIPS = 24;
    // Strips of one grating are in step.
    private static final double STRAIGHT = 0.9;

    int size() {
        return phases.length;
    }

    /** Whether the strips are those of one grating, whose lines go all across. */
    boolean isStraight() {
        return straightness > STRAIGHT;
    }

    /** Radians per place, by least squares: a first guess. */
    double roughSlope() {
        double sum = 0;
        double squares = 0;
        for (int k = 0; k < size(); k++) {
            double place = k - 0.5 * (size() - 1);
            sum += place * phases[k];
            squares += place * place;
        }
        return sum / squares;
    }

    /**
     * Follows the wave of a frequency near the given one.
     *
     * @param frequencyX cycles per metre
     * @param frequencyY cycles per metre, upwards
     */
    static PhaseSeries of(HeightMap map, double frequencyX, double frequencyY) {
        double frequency = Math.hypot(frequencyX, frequencyY);
        DemodulatedHeights heights = DemodulatedHeights.of(map, frequencyX, frequencyY);
        double cosine = frequencyX / frequency;
        double sine = frequencyY / frequency;
        double along = extent(heights.width(), heights.height(), cosine, sine);
        double across = extent(heights.width(), heights.height(), sine, cosine);
        double periods = along * frequency;
        int boxes = periods >= ENOUGH_FOR_LONG ? LONG : SHORT;
        double window = boxes / frequency;
        double step = (periods >= ENOUGH_FOR_WHOLE_STEPS ? 1 : 0.5) / frequency;
        double strip = Math.min(across, STRIP / frequency);
        int strips = (int) Math.min(MOST_STRIPS, Math.max(1, Math.floor((across - strip) / (0.5 * strip)) + 1));
        double stripStep = strips > 1 ? (across - strip) / (strips - 1) : 0;
        DemodulatedHeights.Frame frame = new DemodulatedHeights.Frame(cosine, sine, window, strip, boxes);
        int places = (int) Math.floor((along - window) / step * (1 + 1e-9)) + 1;
        double[][][] amplitudes = new double[Math.max(0, places)][strips][];
        IntStream.range(0, places).parallel().forEach(place -> {
            for (int i = 0; i < strips; i++) {
                double s = (place - 0.5 * (places - 1)) * step;
                double t = (i - 0.5 * (strips - 1)) * stripStep;
                if (heights.covers(s, t, frame)) {
                    amplitudes[place][i] = new double[2];
                    heights.amplitude(s, t, frame, amplitudes[place][i]);
                }
            }
        });
        return joined(amplitudes, step, window, 2 * Math.PI * frequency * stripStep);
    }

    /** Of the longest line in this direction through the patch's middle, metres. */
    private static double extent(double width, double height, double cosine, double sine) {
        return Math.min(width / Math.max(1e-12, Math.abs(cosine)), height / Math.max(1e-12, Math.abs(sine)));
    }

    /** @param across radians by which a wave along the strips turns from one to the next */
    private static PhaseSeries joined(double[][][] all, double step, double window, double across) {
        List<double[][]> run = longestRun(all);
        int count = run.size();
        double[] phases = new double[count];
        double[] strengths = new double[count];
        for (int k = 0; k < count; k++) {
            strengths[k] = strength(run.get(k));
            if (k > 0) {
                double[] turn = sumOfPairs(run.get(k - 1), run.get(k));
                phases[k] = phases[k - 1] + Math.atan2(turn[1], turn[0]);
            }
        }
        double[] lean = new double[2];
        double power = 0;
        for (double[][] strips : run) {
            for (int i = 0; i + 1 < strips.length; i++) {
                if (strips[i] != null && strips[i + 1] != null) {
                    addPair(lean, strips[i], strips[i + 1]);
                    power += Math.hypot(strips[i][0], strips[i][1]) * Math.hypot(strips[i + 1][0], strips[i + 1][1]);
                }
            }
        }
        double straightness = power > 0 ? Math.hypot(lean[0], lean[1]) / power : 1;
        double[][] straight = straight(run, power > 0 ? Math.atan2(lean[1], lean[0]) : 0);
        if (straightness > STRAIGHT) {
            for (int k = 1; k < count; k++) {
                double[] turn = new double[2];
                addPair(turn, straight[k - 1], straight[k]);
                phases[k] = phases[k - 1] + Math.atan2(turn[1], turn[0]);
            }
        }
        double bend = across > 0 ? bend(run, Math.atan2(lean[1], lean[0]), across) : 0;
        return new PhaseSeries(step, phases, strengths, straight, straightness, bend, window / step);
    }

    /** Neighbouring places that share at least one strip. */
    private static List<double[][]> longestRun(double[][][] all) {
        List<double[][]> best = List.of();
        List<double[][]> run = new ArrayList<>();
        for (double[][] place : all) {
            boolean linked = run.isEmpty() ? has(place) : shares(run.get(run.size() - 1), place);
            if (!linked) {
                run = new ArrayList<>();
            }
            if (has(place)) {
                run.add(place);
            }
            best = run.size() > best.size() ? List.copyOf(run) : best;
        }
        return best;
    }

    /** Half the mean square of the angles at which strips see the lines, against their mean lean. */
    private static double bend(List<double[][]> run, double lean, double across) {
        int pairs = run.isEmpty() ? 0 : run.get(0).length - 1;
        double sum = 0;
        int count = 0;
        for (int i = 0; i < pairs; i++) {
            double[] pair = new double[2];
            double power = 0;
            for (double[][] strips : run) {
                if (strips[i] != null && strips[i + 1] != null) {
                    addPair(pair, strips[i], strips[i + 1]);
                    power += Math.hypot(strips[i][0], strips[i][1]) * Math.hypot(strips[i + 1][0], strips[i + 1][1]);
                }
            }
            if (power > 0) {
                count++;
                double angle = Math.IEEEremainder(Math.atan2(pair[1], pair[0]) - lean, 2 * Math.PI) / across;
                sum += Math.hypot(pair[0], pair[1]) > STRAIGHT * power ? angle * angle : 0;
            }
        }
        return count == 0 ? 0 : 0.5 * sum / count;
    }

    private static boolean has(double[][] place) {
        return shares(place, place);
    }

    private static boolean shares(double[][] a, double[][] b) {
        for (int i = 0; i < a.length; i++) {
            if (a[i] != null && b[i] != null) {
                return true;
            }
        }
        return false;
    }

    private static double strength(double[][] strips) {
        double sum = 0;
        int count = 0;
        for (double[] amplitude : strips) {
            if (amplitude != null) {
                sum += amplitude[0] * amplitude[0] + amplitude[1] * amplitude[1];
                count++;
            }
        }
        return Math.sqrt(sum / count);
    }

    private static double[] sumOfPairs(double[][] from, double[][] to) {
        double[] sum = new double[2];
        for (int i = 0; i < from.length; i++) {
            if (from[i] != null && to[i] != null) {
                addPair(sum, from[i], to[i]);
            }
        }
        return sum;
    }

    /** Adds b a*. */
    private static void addPair(double[] sum, double[] a, double[] b) {
        sum[0] += b[0] * a[0] + b[1] * a[1];
        sum[1] += b[1] * a[0] - b[0] * a[1];
    }

    /** The mean over strips, each turned back by its share of the lines' lean against the direction. */
    private static double[][] straight(List<double[][]> run, double lean) {
        double[][] means = new double[run.size()][2];
        for (int k = 0; k < means.length; k++) {
            int count = 0;
            for (int i = 0; i < run.get(k).length; i++) {
                double[] a = run.get(k)[i];
                if (a != null) {
                    double cosine = Math.cos(-lean * i);
                    double sine = Math.sin(-lean * i);
                    means[k][0] += a[0] * cosine - a[1] * sine;
                    means[k][1] += a[0] * sine + a[1] * cosine;
                    count++;
                }
            }
            means[k][0] /= count;
            means[k][1] /= count;
        }
        return means;
    }
}
