package sunbeam.app.measure.errors;

import sunbeam.app.files.cache.DiffractionSetup;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.patch.HeightMap;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.CoherenceArea;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.ReplicatedArea;
import sunbeam.precompute.reference.ReferenceEvaluator;
import sunbeam.precompute.reference.ReplicaEvaluator;

/** The exact power of a pair of directions at a wavelength. Thread-safe. */
@FunctionalInterface
public interface ExactPower {

    /**
     * The power.
     *
     * @param wavelength metres
     */
    double power(DirectionPair pair, double wavelength);

    /** What a method's power is to be: as {@link ExactColor#of}. */
    static ExactPower of(DiffractionSetup setup, Method method) {
        HeightMap map = setup.patch().heights();
        CoherenceArea area = method.exact(map).area();
        if (area instanceof ReplicatedArea replicated) {
            return new ReplicaEvaluator(map, replicated.replicas())::power;
        }
        GaussianArea gaussian = (GaussianArea) area;
        ReferenceEvaluator evaluator = new ReferenceEvaluator(map, gaussian.window(), gaussian.origin());
        return gaussian.average() == Average.ENSEMBLE
                ? (pair, wavelength) -> evaluator.powers(pair, wavelength).ensemble()
                : evaluator::coherent;
    }
}
