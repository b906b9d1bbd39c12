package sunbeam.precompute.resample;

import sunbeam.precompute.expansion.CoefficientTable;

/**
 * A spectrum as a sum of real fields over the DFT bins, with coefficients that depend on the phase alone: complex amplitudes
 * (two fields a term) or powers (one field a term).
 */
public interface Fields {

    int count();

    /** Returns one field, in the table's order of bins. */
    double[] field(int index);

    CoefficientTable coefficients();
}
