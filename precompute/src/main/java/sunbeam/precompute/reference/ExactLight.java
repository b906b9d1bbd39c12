package sunbeam.precompute.reference;

import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.reference.ReferenceColor.Quadrature;
import sunbeam.precompute.reference.ReferenceEvaluator.Power;

/** What a surface diffracts from coherence areas of one kind, without approximation. Immutable and safe for several threads. */
public interface ExactLight {
    /** Power of one coherence area and its mean over all of them, for a wavelength in metres. */
    Power powers(DirectionPair pair, double wavelength);

    /** Whether the mean is seen. */
    boolean ensemble();

    /** What is seen. */
    double power(DirectionPair pair, double wavelength);

    /** X, Y, Z of what is seen, without any gain. */
    double[] xyz(DirectionPair pair, Quadrature quadrature);

    /** The Gaussian window whose effective area the coherence area has. */
    CoherenceWindow window();
}
