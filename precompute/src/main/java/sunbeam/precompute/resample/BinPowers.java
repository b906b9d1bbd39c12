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

    double[] at(int bin) {
        double[] powers = new double[coefficients.length];
        for (int q = 0; q < powers.length; q++) {
            double real = 0;
            double imaginary = 0;
            for (int n = 0; n < terms.length; n++) {
                real += coefficients[q][n] * terms[n].real()[bin];
                imaginary += coefficients[q][n] * terms[n].imaginary()[bin];
            }
            powers[q] = real * real + imaginary * imaginary;
        }
        return powers;
    }
}
