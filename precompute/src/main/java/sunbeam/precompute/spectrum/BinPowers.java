package sunbeam.precompute.spectrum;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.apache.commons.math3.complex.Complex;
import sunbeam.precompute.expansion.PhaseNodes;

/** Powers |F_j|^2 of single DFT bins at nodes of the phase zeta. */
final class BinPowers {
    private final int rows;
    private final int columns;
    private final int terms;
    // [row][(column * terms + term) * 2]: real and imaginary parts
    private final double[][] values;
    // [node][term]
    private final double[][] coefficients;

    BinPowers(FourierTable table, PhaseNodes nodes) {
        rows = table.bandY().count();
        columns = table.bandX().count();
        terms = table.terms();
        values = IntStream.range(0, rows)
                .parallel()
                .mapToObj(row -> row(table, row))
                .toArray(double[][]::new);
        coefficients = new double[nodes.count()][];
        Arrays.setAll(coefficients, q -> table.expansion().coefficients(nodes.node(q)));
    }

    private double[] row(FourierTable table, int row) {
        double[] result = new double[Math.multiplyExact(columns, 2 * terms)];
        for (int n = 0; n < terms; n++) {
            Complex turn = table.expansion().kind().turn(n);
            for (int column = 0; column < columns; column++) {
                double real = table.real()[n][row * columns + column];
                double imaginary = table.imaginary()[n][row * columns + column];
                int at = 2 * (column * terms + n);
                result[at] = real * turn.getReal() - imaginary * turn.getImaginary();
                result[at + 1] = real * turn.getImaginary() + imaginary * turn.getReal();
            }
        }
        return result;
    }

    int bins() {
        return rows * columns;
    }

    double[] at(int bin) {
        double[] powers = new double[coefficients.length];
        at(bin, powers);
        return powers;
    }

    private void at(int bin, double[] powers) {
        Arrays.setAll(powers, q -> power(bin, coefficients[q]));
    }

    /** Returns the mean power of a bin at three nodes, so that a zero at one of them does not hide it. */
    double strength(int bin) {
        int nodes = coefficients.length;
        return (power(bin, coefficients[nodes / 6])
                        + power(bin, coefficients[nodes / 2])
                        + power(bin, coefficients[5 * nodes / 6]))
                / 3;
    }

    /**
     * Returns the inner products, as sums over the nodes, of all bins' powers with functions.
     *
     * @param functions {@code [function][node]}
     * @return {@code [function][bin]}
     */
    double[][] sums(double[][] functions) {
        double[][] sums = new double[functions.length][bins()];
        int pairs = terms * (terms + 1) / 2;
        boolean fewTerms = pairs * (2 + functions.length) < coefficients.length * (2 * terms + functions.length);
        double[][] weights = fewTerms ? pairWeights(functions, pairs) : functions;
        IntStream.range(0, rows).parallel().forEach(row -> {
            double[] inputs = new double[weights[0].length];
            for (int bin = row * columns; bin < (row + 1) * columns; bin++) {
                if (fewTerms) {
                    products(bin, inputs);
                } else {
                    at(bin, inputs);
                }
                for (int n = 0; n < weights.length; n++) {
                    sums[n][bin] = sum(weights[n], inputs);
                }
            }
        });
        return sums;
    }

    /**
     * |sum_a c_a F_a|^2 = sum_ab c_a c_b Re(F_a F_b*), c real: returns the functions' inner products with c_a c_b, twice those for a != b.
     */
    private double[][] pairWeights(double[][] functions, int pairs) {
        double[][] weights = new double[functions.length][pairs];
        for (int n = 0; n < functions.length; n++) {
            for (int q = 0; q < coefficients.length; q++) {
                int pair = 0;
                for (int a = 0; a < terms; a++) {
                    for (int b = a; b < terms; b++) {
                        double twice = a == b ? 1 : 2;
                        weights[n][pair++] += twice * functions[n][q] * coefficients[q][a] * coefficients[q][b];
                    }
                }
            }
        }
        return weights;
    }

    /** Re(F_a F_b*) of a bin's terms, a <= b. */
    private void products(int bin, double[] products) {
        double[] row = values[bin / columns];
        int first = 2 * (bin % columns) * terms;
        int end = first + 2 * terms;
        int pair = 0;
        for (int a = first; a < end; a += 2) {
            double real = row[a];
            double imaginary = row[a + 1];
            for (int b = a; b < end; b += 2) {
                products[pair++] = real * row[b] + imaginary * row[b + 1];
            }
        }
    }

    private static double sum(double[] weights, double[] values) {
        double sum = 0;
        for (int i = 0; i < values.length; i++) {
            sum += weights[i] * values[i];
        }
        return sum;
    }

    private double power(int bin, double[] factors) {
        double[] row = values[bin / columns];
        int at = 2 * (bin % columns) * terms;
        double real = 0;
        double imaginary = 0;
        for (double factor : factors) {
            real += factor * row[at];
            imaginary += factor * row[at + 1];
            at += 2;
        }
        return real * real + imaginary * imaginary;
    }
}
