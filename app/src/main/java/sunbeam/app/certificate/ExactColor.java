package sunbeam.app.certificate;

import sunbeam.app.gpu.MethodKind;
import sunbeam.app.setup.DiffractionSetup;
import sunbeam.app.setup.MethodRequest;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.PlanRequest;
import sunbeam.precompute.reference.ReferenceColor;
import sunbeam.precompute.reference.ReferenceColor.Quadrature;
import sunbeam.precompute.reference.ReferenceEvaluator;
import sunbeam.precompute.reference.ReplicaColor;
import sunbeam.precompute.reference.ReplicaEvaluator;

/** The exact colour of a pair of directions. Thread-safe. */
@FunctionalInterface
public interface ExactColor {

    /** X, Y, Z of power, without any gain. */
    double[] xyz(DirectionPair pair);

    /**
     * What a method's colours are to be: under the Gaussian window, or for {@code pq} of the replicas with sharp edges
     * that it stands for. {@code gem} knows nothing of the surface, and is held against the surface all the same.
     */
    static ExactColor of(DiffractionSetup setup, MethodRequest method, PlanRequest request) {
        return method.kind() == MethodKind.PQ ? ofReplicas(setup, method, request) : ofWindow(setup, request);
    }

    /** Under the Gaussian coherence window that the request asks for, averaged as it says. */
    static ExactColor ofWindow(DiffractionSetup setup, PlanRequest request) {
        ReferenceEvaluator evaluator =
                new ReferenceEvaluator(setup.patch().heights(), request.window(), request.windowOrigin());
        ReferenceColor color = new ReferenceColor(evaluator, request.window(), setup.cie(), Quadrature.INTEGRATED);
        boolean ensemble = request.average().orElse(Average.COHERENT) == Average.ENSEMBLE;
        return pair -> color.xyz(pair, ensemble);
    }

    /** Of the patch repeated as often as the method asks for, with sharp edges. */
    static ExactColor ofReplicas(DiffractionSetup setup, MethodRequest method, PlanRequest request) {
        ReplicaEvaluator evaluator = new ReplicaEvaluator(
                setup.patch().heights(), method.replicasOf(setup.patch().heights(), request.window()));
        return new ReplicaColor(evaluator, setup.cie())::xyz;
    }
}
