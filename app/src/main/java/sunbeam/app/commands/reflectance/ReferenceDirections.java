package sunbeam.app.commands.reflectance;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import sunbeam.app.files.input.DirectionList;
import sunbeam.app.terminal.progress.Progress;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.Gain;
import sunbeam.precompute.reference.ExactLight;
import sunbeam.precompute.reference.ReferenceColor.Quadrature;
import sunbeam.precompute.reference.ReferenceEvaluator.Power;

/** Directions by the exact reference, in parallel over rows. */
record ReferenceDirections(ExactLight light) {

    List<double[]> evaluate(DirectionList list) {
        double[][] results = new double[list.size()][];
        try (Progress progress = Progress.start("Reference", list.size())) {
            IntStream.range(0, list.size()).parallel().forEach(row -> {
                DirectionPair pair = list.pair(row);
                results[row] = list.spectral() ? spectral(pair, list.wavelength(row)) : color(pair);
                progress.step(1);
            });
        }
        return Arrays.asList(results);
    }

    private double[] spectral(DirectionPair pair, double wavelength) {
        Power power = light.powers(pair, wavelength);
        double seen = light.ensemble() ? power.ensemble() : power.coherent();
        return new double[] {
            power.coherent(),
            power.ensemble(),
            Gain.relativeRadiance(pair) * seen,
            Gain.brdf(pair, light.window(), wavelength) * seen
        };
    }

    private double[] color(DirectionPair pair) {
        double[] xyz = light.xyz(pair, Quadrature.EXACT);
        return new double[] {xyz[0], xyz[1], xyz[2], Gain.relativeRadiance(pair)};
    }
}
