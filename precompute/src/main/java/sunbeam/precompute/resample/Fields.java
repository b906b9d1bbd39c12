package sunbeam.precompute.resample;

import sunbeam.precompute.expansion.CoefficientTable;
import sunbeam.precompute.expansion.Expansion;
import sunbeam.precompute.fourier.ComplexVector;
import sunbeam.precompute.optics.WindowOrigin;
import sunbeam.precompute.table.FourierTable;
import sunbeam.precompute.table.WindowPhase;

/**
 * Spectrum as a weighted sum of fields, each with one real value per DFT bin; the weights depend on the phase alone. A term of complex
 * amplitudes has two fields, a term of powers has one.
 *
 * @param values {@code [field][bin]}, bins in the table's order
 */
public record Fields(double[][] values, CoefficientTable coefficients) {
    /** Returns complex amplitudes, with phases relative to the window's origin: real and imaginary part of each term. */
    public static Fields amplitudes(FourierTable table, Expansion expansion, WindowOrigin origin) {
        WindowPhase phase = new WindowPhase(table, origin);
        double[][] values = new double[2 * table.terms()][];
        for (int n = 0; n < table.terms(); n++) {
            ComplexVector term = phase.term(n);
            values[2 * n] = term.real();
            values[2 * n + 1] = term.imaginary();
        }
        return new Fields(values, table.coefficients().orElseGet(() -> CoefficientTable.sampled(expansion)));
    }
}
