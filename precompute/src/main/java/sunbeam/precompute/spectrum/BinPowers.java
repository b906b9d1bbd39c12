package sunbeam.precompute.spectrum;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.apache.commons.math3.complex.Complex;

/** Powers |F_j|^2 of single DFT bins at nodes of the phase zeta. */
final class BinPowers {
    private final FourierTable table;
    private final Complex[] turns;
    // [node][term]
    private final double[][] coefficients;

    BinPowers(FourierTable table, PhaseNodes nodes) {
        this.table = table;
        turns = new Complex[table.terms()];
        Arrays.setAll(turns, table.expansion().kind()::turn);
        coefficients = new double[nodes.count()][];
        Arrays.setAll(coefficients, q -> table.expansion().coefficients(nodes.node(q)));
    }

    private double[] collect(int bin, double[] terms) {
        for (int n = 0; n < turns.length; n++) {
            double real = table.real()[n][bin];
            double imaginary = table.imaginary()[n][bin];
            terms[2 * n] = real * turns[n].getReal() - imaginary * turns[n].getImaginary();
            terms[2 * n + 1] = real * turns[n].getImaginary() + imaginary * turns[n].getReal();
        }
        return terms;
    }

    private double[] terms(int bin) {
        return collect(bin, new double[2 * turns.length]);
    }

    double[] at(int bin) {
        double[] terms = terms(bin);
        return Arrays.stream(coefficients)
                .mapToDouble(node -> power(terms, node))
                .toArray();
    }

    /** Returns the mean power of a bin at three nodes, so that a zero at one of them does not hide it. */
    double strength(int bin) {
        int nodes = coefficients.length;
        double[] terms = terms(bin);
        return (power(terms, coefficients[nodes / 6])
                        + power(terms, coefficients[nodes / 2])
                        + power(terms, coefficients[5 * nodes / 6]))
                / 3;
    }

    /** Returns the inner products {@code [function][bin]} of all bins' powers with functions {@code [function][node]}. */
    double[][] sums(double[][] functions) {
        double[][] sums = new double[functions.length][table.bins()];
        int pairs = turns.length * (turns.length + 1) / 2;
        boolean fewTerms = pairs * (2 + functions.length) < coefficients.length * (2 * turns.length + functions.length);
        double[][] weights = fewTerms ? pairWeights(functions, pairs) : functions;
        int columns = table.bandX().count();
        IntStream.range(0, table.bandY().count()).parallel().forEach(row -> {
            double[] terms = new double[2 * turns.length];
            double[] inputs = new double[weights[0].length];
            for (int bin = row * columns; bin < (row + 1) * columns; bin++) {
                collect(bin, terms);
                if (fewTerms) {
                    products(terms, inputs);
                } else {
                    Arrays.setAll(inputs, q -> power(terms, coefficients[q]));
                }
                for (int n = 0; n < weights.length; n++) {
                    sums[n][bin] = sum(weights[n], inputs);
                }
            }
        });
        return sums;
    }

    /** |sum_a c_a F_a|^2 = sum_ab c_a c_b Re(F_a F_b*), c real: returns the functions' products with c_a c_b, twice those for a != b. */
    private double[][] pairWeights(double[][] functions, int pairs) {
        double[][] weights = new double[functions.length][pairs];
        for (int n = 0; n < functions.length; n++) {
            for (int q = 0; q < coefficients.length; q++) {
                int pair = 0;
                for (int a = 0; a < turns.length; a++) {
                    for (int b = a; b < turns.length; b++) {
                        double twice = a == b ? 1 : 2;
                        weights[n][pair++] += twice * functions[n][q] * coefficients[q][a] * coefficients[q][b];
                    }
                }
            }
        }
        return weights;
    }

    private static void products(double[] terms, double[] products) {
        int pair = 0;
        for (int a = 0; a < terms.length; a += 2) {
            double real = terms[a];
            double imaginary = terms[a + 1];
            for (int b = a; b < terms.length; b += 2) {
                products[pair++] = real * terms[b] + imaginary * terms[b + 1];
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

    private static double power(double[] terms, double[] factors) {
        double real = 0;
        double imaginary = 0;
        for (int n = 0; n < factors.length; n++) {
            real += factors[n] * terms[2 * n];
            imaginary += factors[n] * terms[2 * n + 1];
        }
        return real * real + imaginary * imaginary;
    }
}
