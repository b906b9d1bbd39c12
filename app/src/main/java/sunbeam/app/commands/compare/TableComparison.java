package sunbeam.app.commands.compare;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.apache.commons.math3.stat.correlation.PearsonsCorrelation;
import sunbeam.app.files.input.InputException;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.CsvWriter;
import sunbeam.app.gpu.picture.AutoExposure;
import sunbeam.app.gpu.picture.LinearPicture;
import sunbeam.precompute.color.CieLab;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.ColorDifference;
import sunbeam.precompute.numerics.Quantiles;
import sunbeam.precompute.text.Text;

/**
 * A measured table and what is computed for its directions, row by row.
 *
 * @param factor of what is computed
 * @param isFitted whether the table gave it
 * @param computed each row's values with the factor
 * @param errors of each row: the difference's length over that of what was measured; not finite where that is nothing
 * @param measuredXyz of each row; none of tables without colors
 * @param computedXyz likewise, with the factor
 * @param exposure at which a picture of the measured colors is well lit: white for color differences
 * @param differences CIEDE2000 of each row
 * @param correlation of the logarithms of what is positive in both; NaN for fewer than two
 */
record TableComparison(
        double factor,
        boolean isFitted,
        List<double[]> computed,
        double[] errors,
        List<double[]> measuredXyz,
        List<double[]> computedXyz,
        double exposure,
        double[] differences,
        double correlation) {

    /**
     * @param computed as the table's values
     * @param fixed the factor; empty to fit it
     * @param cie of what spectra are the colors of
     * @throws InputException where nothing can be compared
     */
    static TableComparison of(MeasuredTable table, List<double[]> computed, OptionalDouble fixed, CieTable cie) {
        double[] x = table.fitted(computed);
        double[] y = table.fitted(table.values());
        double factor = fixed.orElseGet(() -> factor(x, y));
        if (!(factor > 0) || !Double.isFinite(factor) || Arrays.stream(y).allMatch(value -> value == 0)) {
            throw new InputException(
                    "what was measured or what is computed is dark in all directions; check angles and patch");
        }
        if (fixed.isEmpty() && Arrays.stream(x).filter(value -> value > 0).count() < 2) {
            throw new InputException(
                    "one value that is not dark fits whatever was measured; give more directions, or --factor");
        }
        List<double[]> scaled = computed.stream()
                .map(row -> Arrays.stream(row).map(value -> factor * value).toArray())
                .toList();
        double[] errors = IntStream.range(0, scaled.size())
                .mapToDouble(row -> error(table.values().get(row), scaled.get(row)))
                .toArray();
        List<double[]> measuredXyz = xyz(table, table.values(), cie);
        List<double[]> computedXyz = xyz(table, scaled, cie);
        double exposure = measuredXyz.isEmpty() ? 1 : exposure(measuredXyz);
        double[] differences = IntStream.range(0, measuredXyz.size())
                .mapToDouble(row -> ColorDifference.ciede2000(
                        lab(measuredXyz.get(row), exposure), lab(computedXyz.get(row), exposure)))
                .toArray();
        return new TableComparison(
                factor,
                fixed.isEmpty(),
                scaled,
                errors,
                measuredXyz,
                computedXyz,
                exposure,
                differences,
                correlation(y, table.fitted(scaled)));
    }

    /**
     * The median of y over x, each counting as its x is light to the eye, by the cube root: a mirror's direction, in which a
     * small angle matters, decides as little as what is lost in noise. NaN where all x are dark.
     */
    static double factor(double[] x, double[] y) {
        List<Integer> byRatio = IntStream.range(0, x.length)
                .filter(i -> x[i] > 0)
                .boxed()
                .sorted(Comparator.comparingDouble(i -> y[i] / x[i]))
                .toList();
        double half = 0.5 * byRatio.stream().mapToDouble(i -> Math.cbrt(x[i])).sum();
        double sum = 0;
        for (int i : byRatio) {
            sum += Math.cbrt(x[i]);
            if (sum >= half) {
                return y[i] / x[i];
            }
        }
        return Double.NaN;
    }

    private static double error(double[] measured, double[] computed) {
        double difference = 0;
        double all = 0;
        for (int i = 0; i < measured.length; i++) {
            difference += Math.pow(computed[i] - measured[i], 2);
            all += measured[i] * measured[i];
        }
        return Math.sqrt(difference / all);
    }

    private static List<double[]> xyz(MeasuredTable table, List<double[]> rows, CieTable cie) {
        if (table.isOfColors()) {
            return rows;
        }
        List<double[]> colors = new ArrayList<>();
        if (table.hasColors()) {
            rows.forEach(row -> colors.add(xyz(table.nanometers(), row, cie)));
        }
        return colors;
    }

    /** Of a spectrum that is linear between its wavelengths and nothing beyond them, by sums in steps of 1 nm. */
    private static double[] xyz(int[] nanometers, double[] spectrum, CieTable cie) {
        double[] xyz = new double[3];
        for (int i = 0; i + 1 < nanometers.length; i++) {
            int step = nanometers[i + 1] - nanometers[i];
            for (int part = 0; part <= step; part++) {
                double share = (double) part / step;
                double value = (1 - share) * spectrum[i] + share * spectrum[i + 1];
                double weight = (part == 0 || part == step ? 0.5e-9 : 1e-9) / cie.integralOfY();
                for (int c = 0; c < 3; c++) {
                    xyz[c] += weight * value * cie.at((nanometers[i] + part) * 1e-9, c);
                }
            }
        }
        return xyz;
    }

    private static double exposure(List<double[]> xyz) {
        float[] pixels = new float[3 * xyz.size()];
        // Small numbers of W/sr and large ones of cd/m2 alike.
        double largest = xyz.stream().mapToDouble(row -> Math.abs(row[1])).max().orElse(1);
        double scale = largest > 0 ? 1 / largest : 1;
        for (int i = 0; i < pixels.length; i++) {
            pixels[i] = (float) (scale * xyz.get(i / 3)[i % 3]);
        }
        return scale * AutoExposure.of(new LinearPicture(xyz.size(), 1, pixels));
    }

    private static CieLab lab(double[] xyz, double exposure) {
        return CieLab.ofXyz(exposure * xyz[0], exposure * xyz[1], exposure * xyz[2]);
    }

    private static double correlation(double[] one, double[] other) {
        int[] lit = IntStream.range(0, one.length)
                .filter(i -> one[i] > 0 && other[i] > 0)
                .toArray();
        return lit.length < 2 ? Double.NaN : new PearsonsCorrelation().correlation(logs(one, lit), logs(other, lit));
    }

    private static double[] logs(double[] values, int[] places) {
        return IntStream.of(places).mapToDouble(i -> Math.log(values[i])).toArray();
    }

    private double error(double quantile) {
        double[] finite = Arrays.stream(errors).filter(Double::isFinite).toArray();
        return finite.length == 0 ? Double.NaN : Quantiles.of(finite, quantile);
    }

    /** A line for each row: its directions, what was measured, what is computed with the factor, and their differences. */
    AtomicFile.StreamContent csv(MeasuredTable table) {
        List<String> names = new ArrayList<>(table.directions().columns());
        table.names().forEach(name -> names.add("measured_" + name));
        table.names().forEach(name -> names.add("computed_" + name));
        names.add("error");
        if (differences.length > 0) {
            names.add("ciede2000");
        }
        return CsvWriter.numbers(
                names,
                errors.length,
                row -> Stream.of(
                                table.directions().row(row),
                                table.values().get(row),
                                computed.get(row),
                                new double[] {errors[row]},
                                differences.length > 0 ? new double[] {differences[row]} : new double[0])
                        .flatMapToDouble(Arrays::stream)
                        .toArray());
    }

    List<String> lines() {
        List<String> lines = new ArrayList<>(List.of(
                Text.format("factor: %.4g, measured over computed%s", factor, isFitted ? "" : ", as given"),
                Text.format(
                        "relative error of %d rows: median %.3g, 95th percentile %.3g",
                        errors.length, error(0.5), error(0.95))));
        if (differences.length > 0) {
            lines.add(Text.format(
                    "CIEDE2000: median %.3g, 95th percentile %.3g, exposed as a picture of the measured colors",
                    Quantiles.of(differences, 0.5), Quantiles.of(differences, 0.95)));
        }
        lines.add("logarithms: " + PhotoComparison.correlation(correlation));
        return lines;
    }

    Map<String, Object> values() {
        Map<String, Object> values = new LinkedHashMap<>();
        values.put("factor", factor);
        values.put("rows", errors.length);
        values.put("error_median", error(0.5));
        values.put("error_p95", error(0.95));
        if (differences.length > 0) {
            values.put("ciede2000_median", Quantiles.of(differences, 0.5));
            values.put("ciede2000_p95", Quantiles.of(differences, 0.95));
        }
        values.put("log_correlation", correlation);
        return values;
    }
}
