package sunbeam.app.commands.evaluate;

import java.awt.Font;
import java.awt.image.BufferedImage;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import sunbeam.app.files.cache.DiffractionSetup;
import sunbeam.app.files.plot.FittedNames;
import sunbeam.precompute.analysis.GratingPeriod;
import sunbeam.precompute.evaluation.GratingMeasurement;
import sunbeam.precompute.evaluation.ResponseGrid;
import sunbeam.precompute.evaluation.ResponseMatrix;
import sunbeam.precompute.method.MethodPlan;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.setting.Choices;

/** A patch's response in the plane of incidence and the period that it shows. */
public final class Evaluation {
    // As plots' titles have it.
    private static final Font TITLE_FONT = new Font(Font.SANS_SERIF, Font.BOLD, 18);
    private static final int WIDEST_NAME = 400;

    private final GratingTarget target;
    private final Responses responses;
    private final Quantity quantity;
    private final ResponseMatrix response;
    private final Optional<GratingMeasurement> measurement;
    private final Optional<String> noRidge;
    private final String name;

    private Evaluation(
            GratingTarget target,
            Responses responses,
            Quantity quantity,
            ResponseMatrix response,
            Optional<GratingMeasurement> measurement,
            Optional<String> noRidge,
            String name) {
        this.target = target;
        this.responses = responses;
        this.quantity = quantity;
        this.response = response;
        this.measurement = measurement;
        this.noRidge = noRidge;
        this.name = name;
    }

    /**
     * @param planned told of the method that a shader uses, once it is planned
     * @param remark told how long it takes where that is long
     */
    static Evaluation of(
            DiffractionSetup setup,
            GratingRequest grating,
            Choices choices,
            ResponseMethod method,
            Quantity quantity,
            Consumer<MethodPlan> planned,
            Consumer<String> remark) {
        CoherenceWindow window = GaussianArea.windowOf(choices);
        Patch patch = setup.patch();
        GratingTarget target = GratingTarget.of(patch, grating);
        DirectionBudget budget =
                new DirectionBudget(patch.heights().width(), patch.heights().height(), window);
        OrdersApart orders = new OrdersApart(
                target.told().map(GratingPeriod::period).orElse(target.order().middle()),
                window,
                patch.repetition() == Patch.Repetition.NONE ? patch.shorterSide() : Double.POSITIVE_INFINITY);
        ResponseGrid grid = grating.grid(target.plane(), target.order(), budget);
        grating.leftOut(grid).ifPresent(remark);
        grating.unseen(target.plane(), target.order()).ifPresent(remark);
        Responses responses = new Responses(setup, method, choices, grid, planned, remark);
        ResponseMatrix response = quantity.of(responses.power());
        Optional<GratingMeasurement> measurement = orders.areTold()
                ? GratingMeasurement.of(response, target.order(), window.sigmaFrequency())
                : Optional.empty();
        if (orders.areTold() && measurement.isEmpty() && target.told().isEmpty()) {
            throw new NoPeriodException(
                    patch.name() + ": " + target.noRidge() + ", or --period (" + target.doubt() + ")");
        }
        Optional<String> noRidge =
                measurement.isPresent() ? Optional.empty() : orders.shortfall().or(() -> Optional.of(target.noRidge()));
        return new Evaluation(target, responses, quantity, response, measurement, noRidge, patch.name());
    }

    /** What of the surface the ridge belongs to, in words. */
    static String area(Choices choices) {
        return GaussianArea.of(choices).average() == Average.ENSEMBLE
                ? "the mean over all positions of the window"
                : "one coherence area";
    }

    /** The patch, the light and the azimuth. */
    public String title() {
        return title(name);
    }

    /** As {@link #title}, with a name that leaves the light its place in a figure of 900 pixels and more. */
    String figureTitle() {
        return title(FittedNames.of(name, TITLE_FONT, WIDEST_NAME));
    }

    private String title(String shown) {
        return String.format(
                Locale.ROOT,
                "%s, light at %s degrees, azimuth %s degrees",
                shown,
                Degrees.text(grid().plane().thetaI()),
                Degrees.text(grid().plane().azimuth()));
    }

    /** Direction of the grating in the patch, radians. */
    public double azimuth() {
        return grid().plane().azimuth();
    }

    /** The ridge of the first order and its periods; empty where light does not tell its orders apart, or shows none. */
    public Optional<GratingMeasurement> measurement() {
        return measurement;
    }

    /** Why there is no ridge; empty where there is one. */
    Optional<String> noRidge() {
        return noRidge;
    }

    /** The thesis's figures 4.9 to 4.11: the response in color, its followed peaks, and the period by the grating equation. */
    public BufferedImage plot() {
        return ResponsePlot.draw(figureTitle(), quantity.label(), response, measurement, target.told());
    }

    GratingTarget target() {
        return target;
    }

    ResponseGrid grid() {
        return response.grid();
    }

    ResponseMatrix response() {
        return response;
    }

    /** One line: what was planned for the shader; nothing for methods that need no plan. */
    Optional<String> plan() {
        return responses.plan();
    }

    Responses responses() {
        return responses;
    }
}
