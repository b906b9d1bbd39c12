package sunbeam.precompute.reference;

import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.reference.ReferenceEvaluator.Power;

/** Exact diffracted power of a surface for one kind of coherence area. Immutable and thread-safe. */
public interface ExactLight {
    enum Quadrature {
        /** Steps are halved until X, Y, Z have nine digits. */
        EXACT,
        /** One pass in smooth light: three times as fast, accurate to 1e-6. */
        INTEGRATED
    }

    /** Returns the power of one coherence area and the ensemble mean, at a wavelength in meters. */
    Power powers(DirectionPair pair, double wavelength);

    /** True if {@link #power} and {@link #xyz} are means over all positions of the coherence area. */
    boolean ensemble();

    /** Returns the power of one coherence area, or the mean if {@link #ensemble}, at a wavelength in meters. */
    double power(DirectionPair pair, double wavelength);

    /** Returns X, Y, Z of the power over 380..780 nm, without a factor of {@code Gain}. */
    double[] xyz(DirectionPair pair, Quadrature quadrature);

    /** Estimates the number of complex products of {@link #xyz} with {@link Quadrature#INTEGRATED}, as a measure of its time. */
    double products(DirectionPair pair);

    /** Gaussian window of the same effective area. */
    CoherenceWindow window();
}
