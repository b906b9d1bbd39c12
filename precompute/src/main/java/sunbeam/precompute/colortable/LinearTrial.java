package sunbeam.precompute.colortable;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/**
 * Whether lines between texels are good enough for a surface: where light comes from everywhere, they are; where orders stand alone in the
 * dark, as those of a grating do, their flanks need splines. Tried in random directions, before anything is made, by single colors: a few
 * around each direction, along u and along v.
 */
public final class LinearTrial {
    // Of 60 errors, the median is known within a fifth of its rank.
    private static final int ENOUGH = 60;
    private static final int TOGETHER = 256;
    private static final int MOST = 2048;
    // With fewer in so many, light is in orders that few see.
    private static final int FEWEST = 10;
    // Pixels see several taps, whose errors even out: those of pictures were a third of single taps'.
    private static final double LENIENCE = 2;
    private static final double LOWEST_COSINE = 0.1;
    private static final long SEED = 2004;
    // Samples before the two that a place lies between; of one farther away POLE^4 is left, 5e-3.
    private static final int BEFORE = 4;
    private static final int SAMPLES = BEFORE + 2;
    private static final int COLORS = 3;

    private final ColorTable.Level level;
    private final ColorSource source;
    private final SplittableRandom random = new SplittableRandom(SEED);

    private LinearTrial(ColorTable.Level level, ColorSource source) {
        this.level = level;
        this.source = source;
    }

    /**
     * Tries a level that is interpolated along lines.
     *
     * @param source of that level's colors
     */
    public static boolean passes(ColorTable levels, int level, ColorSource source) {
        return new LinearTrial(levels.levels().get(level), source).passes(levels.tolerance());
    }

    private boolean passes(double tolerance) {
        List<float[]> lit = new ArrayList<>();
        for (int tried = 0; tried < MOST && lit.size() < ENOUGH; tried += TOGETHER) {
            float[] places = new float[COLORS * TOGETHER];
            for (int i = 0; i < TOGETHER; i++) {
                put(places, i, direction(), direction());
            }
            float[] xyz = source.exact(places);
            for (int i = 0; i < TOGETHER && lit.size() < ENOUGH; i++) {
                if (FootprintErrors.isBright(scaled(xyz, i))) {
                    lit.add(new float[] {places[COLORS * i], places[COLORS * i + 1], places[COLORS * i + 2]});
                }
            }
        }
        return lit.size() >= FEWEST && TableErrors.of(errors(lit)).meet(LENIENCE * tolerance);
    }

    /** Evenly on the hemisphere. */
    private double[] direction() {
        double z = random.nextDouble(LOWEST_COSINE, 1);
        double phi = random.nextDouble(2 * Math.PI);
        double sine = Math.sqrt(1 - z * z);
        return new double[] {sine * Math.cos(phi), sine * Math.sin(phi), z};
    }

    private static void put(float[] places, int at, double[] first, double[] second) {
        for (int axis = 0; axis < COLORS; axis++) {
            places[COLORS * at + axis] = (float) -(first[axis] + second[axis]);
        }
    }

    private double[] scaled(float[] xyz, int at) {
        double[] scaled = new double[COLORS];
        for (int c = 0; c < COLORS; c++) {
            scaled[c] = level.scale() * xyz[COLORS * at + c];
        }
        return scaled;
    }

    /** Of lines along u and along v, which add up; each place lies anywhere between its texels. */
    private double[] errors(List<float[]> lit) {
        int each = 1 + 2 * SAMPLES;
        float[] places = new float[COLORS * each * lit.size()];
        double[] between = new double[lit.size()];
        for (int i = 0; i < between.length; i++) {
            between[i] = random.nextDouble();
            for (int j = 0; j < each; j++) {
                float[] place = lit.get(i).clone();
                if (j > 0) {
                    int sample = (j - 1) % SAMPLES;
                    place[(j - 1) / SAMPLES] += (float)
                            ((sample - BEFORE - between[i]) * level.design().step());
                }
                System.arraycopy(place, 0, places, COLORS * (each * i + j), COLORS);
            }
        }
        float[] xyz = source.exact(places);
        double[] errors = new double[between.length];
        for (int i = 0; i < errors.length; i++) {
            double[] exact = scaled(xyz, each * i);
            double[] computed = new double[COLORS];
            for (int c = 0; c < COLORS; c++) {
                double alongU = line(xyz, each * i + 1, c, between[i]);
                double alongV = line(xyz, each * i + 1 + SAMPLES, c, between[i]);
                computed[c] = Math.pow(alongU + alongV - Math.sqrt(exact[c]), 2);
            }
            errors[i] = TableErrors.relative(computed, exact);
        }
        return errors;
    }

    /** Root of a color by a line through samples. */
    private double line(float[] xyz, int first, int channel, double between) {
        float[] roots = new float[SAMPLES];
        for (int i = 0; i < SAMPLES; i++) {
            roots[i] = (float) Math.sqrt(scaled(xyz, first + i)[channel]);
        }
        Interpolation.SHIFTED_LINES.toCoefficients(roots, SAMPLES, 1);
        double at = BEFORE + between - Interpolation.SHIFTED_LINES.shift();
        int below = (int) at;
        return roots[below] + (at - below) * (roots[below + 1] - roots[below]);
    }
}
