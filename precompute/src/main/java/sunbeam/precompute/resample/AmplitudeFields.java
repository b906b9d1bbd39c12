package sunbeam.precompute.resample;

import java.util.Arrays;
import sunbeam.precompute.expansion.CoefficientTable;
import sunbeam.precompute.expansion.Expansion;
import sunbeam.precompute.fourier.ComplexVector;
import sunbeam.precompute.optics.WindowOrigin;
import sunbeam.precompute.table.FourierTable;
import sunbeam.precompute.table.WindowPhase;

/** Complex amplitudes of the bins as real fields: real part of term 0, imaginary part of term 0, real part of term 1, and so on. */
public final class AmplitudeFields implements Fields {
    private final FourierTable table;
    private final ComplexVector[] terms;
    private final Expansion expansion;

    /** Reads a table, with phases relative to the window's origin. */
    public AmplitudeFields(FourierTable table, Expansion expansion, WindowOrigin origin) {
        this.table = table;
        this.terms = new ComplexVector[table.terms()];
        WindowPhase phase = new WindowPhase(table, origin);
        Arrays.setAll(terms, n -> phase.term(n));
        this.expansion = expansion;
    }

    @Override
    public int count() {
        return 2 * table.terms();
    }

    @Override
    public double[] field(int index) {
        ComplexVector term = terms[index / 2];
        return index % 2 == 0 ? term.real() : term.imaginary();
    }

    @Override
    public CoefficientTable coefficients() {
        return CoefficientTable.sampled(expansion);
    }
}
