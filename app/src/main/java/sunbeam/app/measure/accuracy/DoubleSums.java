package sunbeam.app.measure.accuracy;

import java.util.List;
import java.util.stream.IntStream;
import org.apache.commons.math3.complex.Complex;
import sunbeam.app.measure.accuracy.ReferenceSamples.Power;
import sunbeam.app.measure.errors.RelativeError;
import sunbeam.precompute.expansion.Expansion;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.patch.HeightLevels;
import sunbeam.precompute.reference.ReferenceEvaluator;

/** The power that an expansion yields when everything else is exact: its terms summed over the surface in double. */
final class DoubleSums {
    private final ReferenceEvaluator evaluator;
    private final Expansion expansion;

    DoubleSums(ReferenceEvaluator evaluator, Expansion expansion) {
        this.evaluator = evaluator;
        this.expansion = expansion;
    }

    /** Errors of the first 1, 2, ... terms, at the given numbers of terms, ascending. */
    ErrorCurve errors(List<Power> samples, int... counts) {
        ErrorCurve.Builder curve = new ErrorCurve.Builder(expansion.kind().label() + " double");
        double[][] coefficients = samples.stream().map(this::coefficients).toArray(double[][]::new);
        Complex[] amplitudes = samples.stream().map(sample -> Complex.ZERO).toArray(Complex[]::new);
        int next = 0;
        for (int n = 0; n < counts[counts.length - 1]; n++) {
            double[][] term = term(n);
            Complex turn = expansion.kind().turn(n);
            int index = n;
            IntStream.range(0, samples.size()).parallel().forEach(i -> {
                Complex sum = sum(term, samples.get(i));
                amplitudes[i] = amplitudes[i].add(sum.multiply(turn).multiply(coefficients[i][index]));
            });
            if (n + 1 == counts[next]) {
                curve.add(counts[next++], errors(samples, amplitudes));
            }
        }
        return curve.build();
    }

    private double[] coefficients(Power sample) {
        DirectionPair pair = sample.query().pair();
        return expansion.coefficients(expansion.scale().phase(sample.query().wavelength(), Math.abs(pair.w())));
    }

    /** T_n at every height that occurs: real parts, imaginary parts. */
    private double[][] term(int n) {
        HeightLevels heights = evaluator.heights();
        double[][] parts = new double[2][heights.count()];
        IntStream.range(0, heights.count()).parallel().forEach(i -> {
            Complex value = expansion.basis(n, expansion.scale().scaled(heights.levels()[i]));
            parts[0][i] = value.getReal();
            parts[1][i] = value.getImaginary();
        });
        return parts;
    }

    private Complex sum(double[][] term, Power sample) {
        DirectionPair pair = sample.query().pair();
        double wavelength = sample.query().wavelength();
        return evaluator.windowed(term[0], term[1], pair.u() / wavelength, pair.v() / wavelength);
    }

    private static double[] errors(List<Power> samples, Complex... amplitudes) {
        return IntStream.range(0, amplitudes.length)
                .mapToDouble(i -> {
                    double amplitude = amplitudes[i].abs();
                    return RelativeError.of(
                            amplitude * amplitude, samples.get(i).power());
                })
                .toArray();
    }
}
