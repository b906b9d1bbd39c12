package sunbeam.app.commands.evaluate;

import java.util.OptionalDouble;
import sunbeam.precompute.analysis.HeightSpectrum;
import sunbeam.precompute.analysis.PeriodFinder;
import sunbeam.precompute.analysis.Periodicity;
import sunbeam.precompute.analysis.SpectrumPeak;
import sunbeam.precompute.evaluation.FirstOrder;
import sunbeam.precompute.evaluation.GratingMeasurement;
import sunbeam.precompute.evaluation.GratingPlane;
import sunbeam.precompute.evaluation.ResponseMatrix;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.units.Lengths;

/**
 * What an evaluation aims at, from what the user says and what the heights show.
 *
 * @param patch its name, for messages
 * @param plane light and viewers
 * @param order where the first order is looked for
 * @param heights the regularities of the heights along the plane, or in all directions
 */
record GratingTarget(String patch, GratingPlane plane, FirstOrder order, Periodicity heights) {
    // A surface that repeats one small patch has its exact period; a grown one strays from the heights' mean period by
    // up to a quarter from one coherence area to the next.
    private static final double EXACT = 1.1;
    private static final double GROWN = 1.35;
    private static final double GIVEN = 1.2;

    /**
     * Aims.
     *
     * @throws NoPeriodException where neither the user nor the heights name a period
     */
    static GratingTarget of(Patch patch, GratingRequest request, double sigmaFrequency) {
        PeriodFinder finder = new PeriodFinder(patch.heights());
        OptionalDouble given = request.azimuth();
        Periodicity heights = given.isPresent() ? finder.along(given.getAsDouble(), sigmaFrequency) : finder.all();
        if (!heights.found() && (given.isEmpty() || request.period().isEmpty())) {
            String where =
                    given.isEmpty() ? "" : " along azimuth %s degrees".formatted(Degrees.text(given.getAsDouble()));
            String remedy = given.isEmpty() ? "--azimuth and --period" : "--period, or choose another --azimuth";
            throw new NoPeriodException("%s has no periodicity%s: %s; to look for a ridge all the same give %s"
                    .formatted(patch.name(), where, heights.describeFigure(), remedy));
        }
        double azimuth = given.orElseGet(() -> signed(heights.peaks().get(0)));
        FirstOrder order = request.period().isPresent()
                ? FirstOrder.around(request.period().getAsDouble(), GIVEN)
                : FirstOrder.around(heights.peaks().get(0).period(), spread(heights));
        return new GratingTarget(patch.name(), request.plane(azimuth), order, heights);
    }

    private static double spread(Periodicity heights) {
        return heights.edges() == HeightSpectrum.Edges.PERIODIC ? EXACT : GROWN;
    }

    /** The direction between -90 and 90 degrees: a grating along x, a little off, is lit from +x. */
    private static double signed(SpectrumPeak peak) {
        double direction = peak.direction();
        return direction > Math.PI / 2 ? direction - Math.PI : direction;
    }

    /**
     * Measures a response.
     *
     * @throws NoPeriodException where it has no ridge
     */
    GratingMeasurement measure(ResponseMatrix response, double sigmaFrequency) {
        return GratingMeasurement.of(response, order, sigmaFrequency)
                .orElseThrow(() -> new NoPeriodException(
                        "%s: the response has no ridge of periods from %s to %s within --angles; choose others or --period (the heights: %s)"
                                .formatted(
                                        patch,
                                        Lengths.format(order.shortest()),
                                        Lengths.format(order.longest()),
                                        heights.describeFigure())));
    }
}
