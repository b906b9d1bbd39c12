package sunbeam.app.commands.reflectance;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import sunbeam.app.files.cache.DiffractionSetup;
import sunbeam.app.files.input.DirectionList;
import sunbeam.app.terminal.progress.Progress;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.Gain;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.reference.ReferenceColor;
import sunbeam.precompute.reference.ReferenceEvaluator;

/** Directions by the exact reference, in parallel over rows. */
final class ReferenceDirections {
    private final DiffractionSetup setup;
    private final GaussianArea area;
    private final ReferenceEvaluator evaluator;

    ReferenceDirections(DiffractionSetup setup, GaussianArea area) {
        this.setup = setup;
        this.area = area;
        this.evaluator = new ReferenceEvaluator(setup.patch().heights(), area.window(), area.origin());
    }

    List<double[]> evaluate(DirectionList list) {
        double[][] results = new double[list.size()][];
        try (Progress progress = Progress.start("Reference", list.size())) {
            IntStream.range(0, list.size()).parallel().forEach(row -> {
                results[row] = list.spectral() ? spectral(list, row) : colour(list.pair(row));
                progress.step(1);
            });
        }
        return Arrays.asList(results);
    }

    private double[] spectral(DirectionList list, int row) {
        DirectionPair pair = list.pair(row);
        double wavelength = list.wavelength(row);
        ReferenceEvaluator.Power power = evaluator.powers(pair, wavelength);
        double chosen = ensemble() ? power.ensemble() : power.coherent();
        return new double[] {
            power.coherent(),
            power.ensemble(),
            Gain.relativeRadiance(pair) * chosen,
            Gain.brdf(pair, area.window(), wavelength) * chosen
        };
    }

    private double[] colour(DirectionPair pair) {
        ReferenceColor color = new ReferenceColor(evaluator, area.window(), setup.cie());
        double[] xyz = color.xyz(pair, ensemble());
        return new double[] {xyz[0], xyz[1], xyz[2], Gain.relativeRadiance(pair)};
    }

    private boolean ensemble() {
        return area.average() == Average.ENSEMBLE;
    }
}
