package sunbeam.precompute.resample;

import sunbeam.precompute.expansion.Expansion;
import sunbeam.precompute.expansion.PhaseNodes;
import sunbeam.precompute.fourier.ComplexVector;
import sunbeam.precompute.table.FourierTable;
import sunbeam.precompute.table.WindowPhase;

/** |F_j|^2 of single bins at nodes of the phase. */
final class BinPowers {
    private final ComplexVector[] terms;
    private final double[][] coefficients;

    BinPowers(WindowPhase phase, FourierTable table, Expansion expansion, PhaseNodes nodes) {
        terms = new ComplexVector[table.terms()];
        for (int n = 0; n < terms.length; n++) {
            terms[n] = phase.term(n);
        }
        coefficients = new double[nodes.count()][];
        for (int q = 0; q < coefficients.length; q++) {
            coefficients[q] = expansion.coefficients(nodes.node(q));
        }
    }

    int bins() {
        return terms[0].length();
    }

    /** One bin at all nodes. */
    double[] at(int bin) {
        double[] powers = new double[coefficients.length];
        for (int q = 0; q < powers.length; q++) {
            powers[q] = at(bin, q);
        }
        return powers;
    }

    /** How strong a bin is: its mean at three nodes, so that no zero of one of them hides it. */
    double strength(int bin) {
        int nodes = coefficients.length;
        return (at(bin, nodes / 6) + at(bin, nodes / 2) + at(bin, 5 * nodes / 6)) / 3;
    }

    private double at(int bin, int node) {
        double real = 0;
        double imaginary = 0;
        for (int n = 0; n < terms.length; n++) {
            real += coefficients[node][n] * terms[n].real()[bin];
            imaginary += coefficients[node][n] * terms[n].imaginary()[bin];
        }
        return real * real + imaginary * imaginary;
    }
}
