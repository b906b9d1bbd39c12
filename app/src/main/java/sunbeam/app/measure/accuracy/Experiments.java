package sunbeam.app.measure.accuracy;

import java.util.List;

/** All that is measured. */
final class Experiments {
    private Experiments() {}

    static List<Experiment> all() {
        return List.of(
                new ToleranceExperiment(),
                new TermsExperiment(),
                new RadiusExperiment(),
                new WavelengthExperiment(),
                new MethodsExperiment());
    }
}
