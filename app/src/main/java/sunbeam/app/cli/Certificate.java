package sunbeam.app.cli;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.SplittableRandom;
import java.util.function.IntFunction;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import jrtr.Tile;
import sunbeam.app.picture.LinearPicture;
import sunbeam.app.render.DrawRequest;
import sunbeam.app.render.PartSum;
import sunbeam.app.render.PixelSamples;
import sunbeam.app.render.ScenePicture;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.environment.LightTree;
import sunbeam.app.terminal.ProgressDisplay;
import sunbeam.precompute.errors.Comparison;
import sunbeam.precompute.errors.ErrorStatistics;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.reference.ExactLight;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.work.Progress;

/**
 * Errors of a picture or a table against the exact reference.
 *
 * @param places description of the pixels or rows, such as "40 random pixels"
 * @param complete whether all were evaluated
 * @param quantity XYZ or power
 * @param relative relative errors of the bright ones
 * @param colorDifference their CIEDE2000 after the picture's exposure; empty for a table
 */
public record Certificate(
        String places,
        boolean complete,
        String quantity,
        ErrorStatistics relative,
        ErrorStatistics colorDifference,
        Limits limits) {
    /** Each run chooses the same pixels or rows. */
    static final long SEED = 1;

    /** Largest relative errors and mean CIEDE2000; infinite for no limit. */
    public record Limits(double median, double percentile95, double meanDifference) {
        /** A CIEDE2000 of 1 is just visible. */
        public static final Limits ANTI_ALIASED = new Limits(0.02, Double.POSITIVE_INFINITY, 1);

        /**
         * Limits of a map of a wide light: it looks like one of the light's disc, as a scene does, whose footprints blur by the same Gaussian,
         * of the right width at 550 nm only. Sharp orders miss them (docs/scenes.md).
         */
        public static Limits ofLamp(double tolerance) {
            return new Limits(
                    Math.max(tolerance, ANTI_ALIASED.median), Double.POSITIVE_INFINITY, ANTI_ALIASED.meanDifference);
        }

        /** Limits under an environment: its lights may err as much as the rest (LightCount), independently of it. */
        public static final Limits UNDER_ENVIRONMENT = new Limits(
                Math.sqrt(2) * ANTI_ALIASED.median,
                Double.POSITIVE_INFINITY,
                Math.sqrt(2) * ANTI_ALIASED.meanDifference);

        /** Limits of a tolerance: the median may reach it, the 95th percentile three times it. */
        public static Limits of(double tolerance) {
            return new Limits(tolerance, ErrorStatistics.PERCENTILE_95_LIMIT * tolerance, Double.POSITIVE_INFINITY);
        }

        /** Limits of an exported table: on the steep flanks of orders the 95th percentile is four to nine tolerances. */
        public static Limits ofExport(double tolerance) {
            return new Limits(tolerance, 10 * tolerance, Double.POSITIVE_INFINITY);
        }

        /** True if the errors are within the limits, or if there are none. */
        public boolean hold(ErrorStatistics relative) {
            return relative.count() == 0 || (relative.median() <= median && relative.percentile95() <= percentile95);
        }
    }

    /** @param exposure factor for X, Y, Z before colors are compared */
    static Certificate ofPixels(String places, List<Comparison> compared, double exposure, Limits limits) {
        ErrorStatistics differences = ErrorStatistics.of(compared.stream()
                .filter(Comparison::bright)
                .mapToDouble(pixel -> pixel.colorDifference(exposure))
                .toArray());
        return new Certificate(places, false, "XYZ", Comparison.relative(compared), differences, limits);
    }

    /** Compares random rows, at most all, of a table made for relative error {@code tolerance}; {@code row} compares one, from 0. */
    public static Certificate ofRows(
            ProgressDisplay display,
            int rows,
            int count,
            IntFunction<Comparison> row,
            String quantity,
            double tolerance) {
        List<Integer> chosen = new ArrayList<>(IntStream.range(0, rows).boxed().toList());
        Collections.shuffle(chosen, new Random(SEED));
        List<Comparison> compared = display.map("Certificate", chosen.subList(0, Math.min(rows, count)), row::apply);
        boolean all = compared.size() == rows;
        return new Certificate(
                all ? "all " + rows + " rows" : compared.size() + " random rows",
                all,
                quantity,
                Comparison.relative(compared),
                ErrorStatistics.of(),
                Limits.of(tolerance));
    }

    public boolean missed() {
        boolean even = colorDifference.count() == 0 || colorDifference.mean() <= limits.meanDifference();
        return relative.count() > 0 && !(limits.hold(relative) && even);
    }

    public String summary() {
        if (relative.count() == 0) {
            return Text.format("%s, all darker than %.0e: nothing to compare", places, Comparison.FLOOR);
        }
        String errors = Text.format(
                "%s, %d of them above %.0e: relative error of %s %s",
                places, relative.count(), Comparison.FLOOR, quantity, relative);
        String colors = colorDifference.count() == 0
                ? ""
                : Text.format(
                        "; CIEDE2000 mean %.2g, median %.2g, maximum %.2g",
                        colorDifference.mean(), colorDifference.median(), colorDifference.maximum());
        return errors + colors + (complete ? "" : relative.doubt());
    }

    /** Returns each limited error with its limit: "median 0.02 (at most 0.01)". */
    public String comparison() {
        return Stream.of(
                        limited("median", relative.median(), limits.median()),
                        limited("95th percentile", relative.percentile95(), limits.percentile95()),
                        limited("mean CIEDE2000", colorDifference.mean(), limits.meanDifference()))
                .filter(words -> !words.isEmpty())
                .collect(Collectors.joining(", "));
    }

    private static String limited(String what, double value, double limit) {
        return Double.isInfinite(limit) ? "" : Text.format("%s %.2g (at most %.2g)", what, value, limit);
    }

    /**
     * Compares random pixels of a BRDF map, row by row from the top left, with the mean over points of light; the gain is the radiance per
     * diffracted power.
     */
    public record Certifier(
            ExactLight reference,
            List<IntFunction<DirectionPair>> points,
            ToDoubleFunction<DirectionPair> gain,
            ProgressDisplay display) {
        // Some dark pixels, where light may be missing; but a grating is nearly all dark.
        private static final int PIXELS_PER_DARK = 4;

        /**
         * Evaluates {@code count} random pixels of the surface, at most all, in parallel; at most a quarter are dark if there are enough
         * bright ones. The picture is linear XYZ of rho; the exposure is its factor before colors are compared.
         */
        public Certificate certify(LinearPicture picture, int count, double exposure, Limits limits) {
            List<Comparison> all = display.map("Certificate", draw(picture, count), pixel -> compare(picture, pixel));
            return ofPixels(
                    all.size() + " random pixels, at most a quarter of them dark while there are others",
                    all,
                    exposure,
                    limits);
        }

        private List<Integer> draw(LinearPicture picture, int count) {
            List<Integer> bright = new ArrayList<>();
            List<Integer> dark = new ArrayList<>();
            for (int pixel = 0; pixel < picture.width() * picture.height(); pixel++) {
                if (picture.covered(pixel)) {
                    double floor =
                            Comparison.FLOOR * gain.applyAsDouble(points.get(0).apply(pixel));
                    // A NaN or an infinite value makes a pixel bright, so that it is checked.
                    (Comparison.largest(Comparison.xyz(picture.xyz(), pixel)) <= floor ? dark : bright).add(pixel);
                }
            }
            Random random = new Random(SEED);
            Collections.shuffle(bright, random);
            Collections.shuffle(dark, random);
            int reservedDark = Math.min(dark.size(), count / PIXELS_PER_DARK);
            int brightCount = Math.min(bright.size(), count - reservedDark);
            List<Integer> pixels = new ArrayList<>(bright.subList(0, brightCount));
            pixels.addAll(dark.subList(0, Math.min(dark.size(), count - brightCount)));
            return pixels;
        }

        private Comparison compare(LinearPicture picture, int pixel) {
            double[] exact = new double[3];
            for (IntFunction<DirectionPair> point : points) {
                DirectionPair pair = point.apply(pixel);
                if (pair.cosThetaI() > 0) {
                    double share = gain.applyAsDouble(pair) / points.size();
                    double[] xyz = reference.xyz(pair, ExactLight.Quadrature.INTEGRATED);
                    Arrays.setAll(exact, c -> exact[c] + share * xyz[c]);
                }
            }
            double factor = gain.applyAsDouble(points.get(0).apply(pixel));
            return new Comparison(Comparison.xyz(picture.xyz(), pixel), exact, factor);
        }
    }

    /**
     * Compares pixels that the mesh fills with the mean of many points; at edges only the number of samples decides. Where relief is finer
     * than a pixel, or an environment shines, each point is a mean over many slopes or lights: pixels are compared with fewer first.
     */
    public record SceneCertifier(int width, int height, PixelSamples samples, ProgressDisplay display) {
        /** Points along a pixel's side; 256 in all. */
        public static final int POINTS = 16;
        // Points of half the side see half the slopes each: an eighth of the time. Their mean errs by 0.2 % in the
        // median.
        private static final int FEW_POINTS = POINTS / 2;
        // Tries per compared pixel: the mesh may fill few.
        private static final int MOST_TRIES = 200;

        /**
         * Draws random pixels, fewer than {@code count} if the mesh fills fewer, by the renderer to be judged and by one of the same scene
         * by points. The exposure is a factor for X, Y, Z before colors are compared.
         */
        public Certificate certify(
                PartSum drawn, Scene scene, PartSum exact, Scene points, double exposure, int count) {
            int most = most(points);
            SplittableRandom random = new SplittableRandom(SEED);
            List<Comparison> compared = new ArrayList<>();
            try (Progress progress = display.start("Certificate", count)) {
                for (int i = 0; i < MOST_TRIES * count && compared.size() < count; i++) {
                    Tile pixel = new Tile(random.nextInt(width), random.nextInt(height), 1, 1);
                    if (exact.pick(pixel.x(), pixel.y(), width, height).isPresent()) {
                        compare(drawn, scene, exact, points, pixel, exposure).ifPresent(one -> {
                            compared.add(one);
                            progress.step(1);
                        });
                    }
                }
            }
            String fewer = first(points) < most
                    ? Text.format(
                            " (of %d if these differ by less than %.0f %%)",
                            FEW_POINTS * FEW_POINTS, 100 * Limits.ANTI_ALIASED.median())
                    : "";
            String lights =
                    isUnderFinest(points) ? Text.format(" under %d regions of the environment", LightTree.FINEST) : "";
            String places = Text.format(
                    "%d random pixels that the mesh fills, beside the mean of %d points in each%s%s",
                    compared.size(), most * most, fewer, lights);
            Limits limits = points.hasEnvironment() ? Limits.UNDER_ENVIRONMENT : Limits.ANTI_ALIASED;
            return ofPixels(places, compared, exposure, limits);
        }

        /** Returns the first number of points along a side: few where each is a mean over slopes or lights itself. */
        private static int first(Scene points) {
            return points.slopeDeviation() > 0 || points.hasEnvironment() ? FEW_POINTS : POINTS;
        }

        private static int most(Scene points) {
            return isUnderFinest(points) ? FEW_POINTS : POINTS;
        }

        /** True if points read the table's colors, whose own errors are stated beside: points of method full would need hours. */
        private static boolean isUnderFinest(Scene points) {
            return points.hasEnvironment() && points.method().isTable();
        }

        /** Returns empty if the mesh does not fill the pixel. */
        private Optional<Comparison> compare(
                PartSum drawn, Scene scene, PartSum exact, Scene points, Tile pixel, double exposure) {
            Optional<double[]> mean = mean(exact, points, pixel, first(points));
            if (mean.isEmpty()) {
                return Optional.empty();
            }
            ScenePicture picture =
                    drawn.draw(scene, width, height, pixel, samples, exposure).light();
            double[] xyz = Comparison.xyz(picture.rgba(), 0);
            // The gain is that of white, for Comparison's floor of dark pixels.
            Comparison compared = new Comparison(xyz, mean.get(), 1);
            boolean isDoubtful = first(points) < most(points) && compared.relative() > Limits.ANTI_ALIASED.median();
            return isDoubtful
                    ? mean(exact, points, pixel, most(points)).map(finer -> new Comparison(xyz, finer, 1))
                    : Optional.of(compared);
        }

        /** Returns the mean of a pixel's points; empty if the mesh does not fill the pixel. */
        private Optional<double[]> mean(PartSum exact, Scene scene, Tile pixel, int side) {
            ScenePicture mean = exact.draw(DrawRequest.ofPixels(scene, width, height, pixel, side))
                    .reduced(side);
            return mean.rgba()[3] > 1 - 0.5f / (side * side)
                    ? Optional.of(Comparison.xyz(mean.rgba(), 0))
                    : Optional.empty();
        }
    }
}
