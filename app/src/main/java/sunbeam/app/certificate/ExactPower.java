package sunbeam.app.certificate;

import sunbeam.app.gpu.MethodKind;
import sunbeam.app.setup.DiffractionSetup;
import sunbeam.app.setup.MethodRequest;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.patch.HeightMap;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.PlanRequest;
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
    static ExactPower of(DiffractionSetup setup, MethodRequest method, PlanRequest request) {
        HeightMap map = setup.patch().heights();
        if (method.kind() == MethodKind.PQ) {
            return new ReplicaEvaluator(map, method.replicasOf(map, request.window()))::power;
        }
        ReferenceEvaluator evaluator = new ReferenceEvaluator(map, request.window(), request.windowOrigin());
        return request.average().orElse(Average.COHERENT) == Average.ENSEMBLE
                ? (pair, wavelength) -> evaluator.powers(pair, wavelength).ensemble()
                : evaluator::coherent;
    }
}
