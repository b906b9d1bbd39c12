package sunbeam.app.commands.reflectance;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import sunbeam.app.files.cache.DiffractionSetup;
import sunbeam.app.files.input.DirectionList;
import sunbeam.app.terminal.progress.Progress;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.Gain;
import sunbeam.precompute.optics.Replicas;
import sunbeam.precompute.patch.HeightMap;
import sunbeam.precompute.reference.ReplicaColor;
import sunbeam.precompute.reference.ReplicaEvaluator;

/** Directions by the exact sum over replicas with sharp edges, the reference of method {@code pq}. */
final class ReplicaDirections {
    private final ReplicaEvaluator evaluator;
    private final ReplicaColor color;
    private final CoherenceWindow equalArea;

    ReplicaDirections(DiffractionSetup setup, Replicas replicas) {
        HeightMap map = setup.patch().heights();
        evaluator = new ReplicaEvaluator(map, replicas);
        color = new ReplicaColor(evaluator, setup.cie());
        equalArea = replicas.equalAreaWindow(map.width(), map.height());
    }

    List<double[]> evaluate(DirectionList list) {
        double[][] results = new double[list.size()][];
        try (Progress progress = Progress.start("Reference", list.size())) {
            IntStream.range(0, list.size()).parallel().forEach(row -> {
                DirectionPair pair = list.pair(row);
                results[row] = list.spectral() ? spectral(pair, list.wavelength(row)) : colour(pair);
                progress.step(1);
            });
        }
        return Arrays.asList(results);
    }

    private double[] spectral(DirectionPair pair, double wavelength) {
        double power = evaluator.power(pair, wavelength);
        return new double[] {
            power, power, Gain.relativeRadiance(pair) * power, Gain.brdf(pair, equalArea, wavelength) * power
        };
    }

    private double[] colour(DirectionPair pair) {
        double[] xyz = color.xyz(pair);
        return new double[] {xyz[0], xyz[1], xyz[2], Gain.relativeRadiance(pair)};
    }
}
