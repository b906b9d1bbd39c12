package sunbeam.app.commands.evaluate;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.apache.commons.math3.stat.StatUtils;
import sunbeam.app.terminal.progress.Progress;
import sunbeam.precompute.evaluation.BinSums;
import sunbeam.precompute.evaluation.FirstOrder;
import sunbeam.precompute.evaluation.GratingMeasurement;
import sunbeam.precompute.evaluation.ResponseMatrix;
import sunbeam.precompute.evaluation.WindowPlace;
import sunbeam.precompute.numerics.Quantiles;

/**
 * The period as single coherence areas see it, from window positions drawn at random all over the patch: what one such
 * figure is worth.
 *
 * @param places all positions that were drawn
 * @param periods for each the mean period from interpolated peaks, metres; NaN where there is no ridge
 * @param ensemble the same from the mean response over all positions, metres; NaN where there is no ridge
 */
record Positions(List<WindowPlace> places, double[] periods, double ensemble) {
    // Responses that are held at the same time.
    private static final int PORTION = 8;

    /** Where the window may stand: samples of the patch, and the seed of the choice. */
    record Draw(int count, long seed, int columns, int rows) {
        List<WindowPlace> places() {
            SplittableRandom random = new SplittableRandom(seed);
            List<WindowPlace> places = new ArrayList<>(count);
            for (int i = 0; i < count; i++) {
                places.add(new WindowPlace(random.nextInt(columns), random.nextInt(rows)));
            }
            return places;
        }
    }

    static Positions measure(BinSums sums, Draw draw, Quantity quantity, FirstOrder order, double sigmaFrequency) {
        List<WindowPlace> places = draw.places();
        double[] periods = new double[places.size()];
        try (Progress progress = Progress.start("Positions", places.size())) {
            for (int start = 0; start < periods.length; start += PORTION) {
                int end = Math.min(periods.length, start + PORTION);
                List<ResponseMatrix> responses = sums.coherent(places.subList(start, end), row -> {});
                for (int i = start; i < end; i++) {
                    periods[i] = period(quantity.of(responses.get(i - start)), order, sigmaFrequency);
                }
                progress.step(end - start);
            }
            double ensemble = period(quantity.of(sums.ensemble(row -> {})), order, sigmaFrequency);
            return new Positions(places, periods, ensemble);
        }
    }

    private static double period(ResponseMatrix response, FirstOrder order, double sigmaFrequency) {
        Optional<GratingMeasurement> measurement = GratingMeasurement.of(response, order, sigmaFrequency);
        return measurement.map(found -> found.interpolated().mean()).orElse(Double.NaN);
    }

    /** The periods that were found, ascending, metres. */
    double[] sorted() {
        return Arrays.stream(periods)
                .filter(period -> !Double.isNaN(period))
                .sorted()
                .toArray();
    }

    /** The period below which a share, 0..1, of the positions lies; NaN where none has one. */
    double quantile(double share) {
        return Quantiles.of(sorted(), share);
    }

    double mean() {
        return StatUtils.mean(sorted());
    }

    /** Standard deviation over the positions, metres. */
    double deviation() {
        return Math.sqrt(StatUtils.variance(sorted()));
    }
}
