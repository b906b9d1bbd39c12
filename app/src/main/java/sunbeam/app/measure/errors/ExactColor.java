package sunbeam.app.measure.errors;

import sunbeam.app.files.cache.DiffractionSetup;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.patch.HeightMap;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.CoherenceArea;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.ReplicatedArea;
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
    static ExactColor of(DiffractionSetup setup, Method method) {
        HeightMap map = setup.patch().heights();
        CoherenceArea area = method.exact(map).area();
        return area instanceof ReplicatedArea replicated
                ? new ReplicaColor(new ReplicaEvaluator(map, replicated.replicas()), setup.cie())::xyz
                : ofWindow(setup, (GaussianArea) area);
    }

    private static ExactColor ofWindow(DiffractionSetup setup, GaussianArea area) {
        ReferenceEvaluator evaluator = new ReferenceEvaluator(setup.patch().heights(), area.window(), area.origin());
        ReferenceColor color = new ReferenceColor(evaluator, area.window(), setup.cie(), Quadrature.INTEGRATED);
        boolean ensemble = area.average() == Average.ENSEMBLE;
        return pair -> color.xyz(pair, ensemble);
    }
}
