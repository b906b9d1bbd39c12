package sunbeam.app.commands.figures;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import sunbeam.app.commands.figures.Panel.MapPanel;
import sunbeam.precompute.expansion.ExpansionKind;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.GemMethod;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.method.NmmMethod;
import sunbeam.precompute.method.PqMethod;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.plan.ErrorBudget;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.resample.PeriodInterpolation;

/** The thesis's BRDF maps, figures 5.3 to 5.13. */
final class MapFigures {
    private static final FullMethod PLANNED = FullMethod.within(ErrorBudget.STANDARD);
    private static final FullMethod THESIS = FullMethod.thesis().with(GaussianArea.STANDARD);
    private static final NmmMethod NMM = NmmMethod.within(ErrorBudget.STANDARD);
    private static final NmmMethod NMM_THESIS = new NmmMethod(THESIS.table(), THESIS.area());
    private static final double[] STEPS_NANOMETRES = {1, 5, 10, 20, 40};
    private static final int[] TERMS = {2, 4, 6, 8, 12, 16, 24, 37};
    private static final double[] COHERENCE_LENGTHS_MICROMETRES = {65, 32, 16, 8, 4};
    private static final double[] THETAS_DEGREES = {0, 15, 30, 45, 60, 75};

    private MapFigures() {}

    static List<Figure> all(double gemSpacing) {
        return List.of(
                patches(),
                methods(gemSpacing),
                steps("5.5", Role.BLAZE),
                steps("5.6", Role.ELAPHE),
                againstPq("5.7", Role.BLAZE),
                againstPq("5.8", Role.ELAPHE),
                againstPq("5.9", Role.XENOPELTIS),
                windows(),
                terms("5.11", Role.BLAZE),
                terms("5.12", Role.ELAPHE),
                incidence());
    }

    private static Figure patches() {
        List<Panel> panels = new ArrayList<>();
        for (Role role : Role.values()) {
            panels.add(new Maps("5.3", role, 0).planned());
        }
        return new Figure(
                "5.3",
                "BRDF maps of the patches",
                "The blazed grating sends its light into the first order on one side, left of the centre, as the blaze"
                        + " wants it; Elaphe spreads colours along the horizontal only; Xenopeltis has many near-vertical"
                        + " directions, because the fingers of its scales do.",
                panels);
    }

    private static Figure methods(double gemSpacing) {
        List<Panel> panels = new ArrayList<>();
        for (Role role : Role.values()) {
            Maps maps = new Maps("5.4", role, 0);
            panels.add(maps.planned());
            panels.add(maps.compared("thesis", "full with the thesis's choices, window centred", THESIS));
            panels.add(maps.compared("nmm", "nmm", NMM));
            panels.add(maps.compared("nmm-thesis", "nmm as in the thesis, unweighted", NMM_THESIS));
            panels.add(maps.compared("pq", "pq, sinc", pq(PeriodInterpolation.SINC)));
            panels.add(maps.alone("gem", "gem, for comparison only", gem(gemSpacing)));
        }
        return new Figure(
                "5.4",
                "BRDF maps by method",
                "nmm takes one wavelength for each order and is meant for a patch of one period: right for the blazed"
                        + " grating, not for the skins. pq repeats the patch with sharp edges. gem draws the lines of a"
                        + " grating and knows nothing of the surface.",
                panels);
    }

    private static Figure steps(String number, Role role) {
        Maps maps = new Maps(number, role, 0);
        List<Panel> panels = new ArrayList<>(List.of(maps.planned()));
        for (double step : STEPS_NANOMETRES) {
            String name = String.format(Locale.ROOT, "%.0fnm", step);
            panels.add(maps.compared(
                    name,
                    String.format(Locale.ROOT, "steps of %.0f nm", step),
                    PLANNED.with(PLANNED.table().withWavelengthStep(step * 1e-9))));
        }
        return new Figure(
                number,
                "Wavelength steps, " + role.label(),
                "Equal steps of the wavelength; from 10 nm on an order falls apart into single spots of one colour.",
                panels);
    }

    private static Figure againstPq(String number, Role role) {
        Maps maps = new Maps(number, role, 0);
        List<Panel> panels = List.of(
                maps.planned(),
                maps.compared("pq-sinc", "pq, sinc interpolation", pq(PeriodInterpolation.SINC)),
                maps.compared("pq-linear", "pq, linear interpolation", pq(PeriodInterpolation.LINEAR)));
        return new Figure(
                number,
                "full against pq, " + role.label(),
                "pq weighs a whole number of replicas alike instead of by a Gaussian: side lobes of the sinc stand between"
                        + " the orders.",
                panels);
    }

    private static Figure windows() {
        List<Panel> panels = new ArrayList<>();
        for (Role role : Role.values()) {
            for (double length : COHERENCE_LENGTHS_MICROMETRES) {
                String label =
                        String.format(Locale.ROOT, "sigma_s %.2f um (coherence length %.0f um)", length / 4, length);
                panels.add(new Maps("5.10", role, 0)
                        .alone(
                                String.format(Locale.ROOT, "%.0fum", length),
                                label,
                                PLANNED.with(
                                        GaussianArea.STANDARD.with(CoherenceWindow.ofCoherenceLength(length * 1e-6)))));
            }
        }
        return new Figure(
                "5.10",
                "Coherence windows",
                "The smaller the coherence area, the broader the orders: they blur and overlap, and speckle grows until it"
                        + " is gone.",
                panels);
    }

    private static Figure terms(String number, Role role) {
        Maps maps = new Maps(number, role, 0);
        List<Panel> panels = new ArrayList<>(List.of(maps.planned()));
        for (int count : TERMS) {
            panels.add(maps.compared(
                    "taylor" + count,
                    count + " Taylor terms",
                    PLANNED.with(PLANNED.table().withExpansion(ExpansionKind.TAYLOR, count))));
        }
        return new Figure(
                number,
                "Number of Taylor terms, " + role.label(),
                "Too few terms fail first where the phase is largest: in the blue and at small angles.",
                panels);
    }

    private static Figure incidence() {
        List<Panel> panels = new ArrayList<>();
        for (Role role : Role.values()) {
            for (double theta : THETAS_DEGREES) {
                panels.add(new Maps("5.13", role, theta).planned());
            }
        }
        return new Figure(
                "5.13",
                "Angles of incidence",
                "The specular spot and with it all orders move to the other side of the light.",
                panels);
    }

    private static Method pq(PeriodInterpolation interpolation) {
        return PqMethod.within(ErrorBudget.STANDARD, interpolation);
    }

    private static Method gem(double spacing) {
        return new GemMethod(OptionalDouble.of(spacing), GaussianArea.STANDARD.window());
    }

    /** The maps of one patch in one figure. */
    private record Maps(String figure, Role role, double thetaDegrees) {
        MapPanel planned() {
            String label = String.format(Locale.ROOT, "full as planned, light at %.0f degrees", thetaDegrees);
            return alone("full-" + String.format(Locale.ROOT, "%.0f", thetaDegrees), label, PLANNED);
        }

        MapPanel alone(String name, String label, Method method) {
            return panel(name, label, method, Optional.empty());
        }

        MapPanel compared(String name, String label, Method method) {
            return panel(name, label, method, Optional.of(planned()));
        }

        private MapPanel panel(String name, String label, Method method, Optional<MapPanel> base) {
            String file = figure + "-" + role.label() + "-" + name;
            return new MapPanel(file, role, label, thetaDegrees, method, base);
        }
    }
}
