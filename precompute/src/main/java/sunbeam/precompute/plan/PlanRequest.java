package sunbeam.precompute.plan;

import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import sunbeam.precompute.expansion.ExpansionKind;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.WindowOrigin;

/**
 * What a user fixes of a {@link Plan}; the planner chooses the rest.
 *
 * @param preset whether the thesis's choices stand in for what is not fixed
 * @param tolerance relative error that what is not fixed is chosen for
 * @param expansion kind of expansion
 * @param terms number of its terms
 * @param radius of the neighbourhood of bins
 * @param anchor its middle
 * @param wavelengthStep metres
 * @param origin the sample under the window's maximum
 * @param coherenceLength four standard deviations of the window, metres
 * @param average which power
 */
public record PlanRequest(
        Preset preset,
        double tolerance,
        Optional<ExpansionKind> expansion,
        OptionalInt terms,
        OptionalInt radius,
        Optional<Neighbourhood.Anchor> anchor,
        OptionalDouble wavelengthStep,
        Optional<WindowOrigin> origin,
        OptionalDouble coherenceLength,
        Optional<Average> average) {

    /** Where choices come from that the user does not make. */
    public enum Preset {
        /** Planned. */
        NONE,
        /** The thesis's shader: 37 Taylor terms, 5 nm, 3 x 3 bins anchored with floor, window on the corner. */
        THESIS
    }

    /** Nothing fixed but the preset. */
    public static PlanRequest of(Preset preset) {
        return new PlanRequest(
                preset,
                Tolerances.STANDARD,
                Optional.empty(),
                OptionalInt.empty(),
                OptionalInt.empty(),
                Optional.empty(),
                OptionalDouble.empty(),
                Optional.empty(),
                OptionalDouble.empty(),
                Optional.empty());
    }

    /** Whether the thesis's choices stand in for what is not fixed. */
    public boolean isThesis() {
        return preset == Preset.THESIS;
    }

    /** Whether a choice is made that only a sum over DFT bins at fixed wavelengths has. */
    public boolean fixesBins() {
        return radius.isPresent() || anchor.isPresent() || wavelengthStep.isPresent();
    }

    /** The same with equal steps of the wavelength, metres, where none are fixed: a plan for sums over DFT bins. */
    public PlanRequest orWavelengthStep(double metres) {
        return new PlanRequest(
                preset,
                tolerance,
                expansion,
                terms,
                radius,
                anchor,
                OptionalDouble.of(wavelengthStep.orElse(metres)),
                origin,
                coherenceLength,
                average);
    }

    /** The window, sunlight's unless asked otherwise. */
    public CoherenceWindow window() {
        return CoherenceWindow.ofCoherenceLength(coherenceLength.orElse(CoherenceWindow.SUNLIGHT_COHERENCE_LENGTH));
    }

    /** What is fixed of tables and wavelengths. */
    public TableChoices table() {
        return new TableChoices(
                isThesis() ? new Accuracy.ThesisPreset() : new Accuracy.ByTolerance(tolerance),
                expansion,
                terms,
                wavelengthStep);
    }

    /**
     * The neighbourhood of bins that is fixed, if any.
     *
     * @throws PlanException for a middle of none
     */
    public Optional<Neighbourhood> neighbourhood() {
        if (radius.isEmpty() && anchor.isEmpty()) {
            return Optional.empty();
        }
        if (radius.isEmpty() && !isThesis()) {
            throw new PlanException(
                    "anchor %s is the middle of a neighbourhood of bins, but no radius is given; add for example --radius 3, or leave --anchor out"
                            .formatted(anchor.get().toString().toLowerCase(Locale.ROOT)));
        }
        Neighbourhood.Anchor usual = isThesis() ? Neighbourhood.Anchor.FLOOR : Neighbourhood.Anchor.NEAREST;
        return Optional.of(new Neighbourhood(radius.orElse(1), anchor.orElse(usual)));
    }

    /** The window, its place, and which power. */
    public GaussianArea area() {
        return new GaussianArea(window(), windowOrigin(), average.orElse(Average.COHERENT));
    }

    /** The window's place: the patch's centre unless the thesis is asked for. */
    public WindowOrigin windowOrigin() {
        return origin.orElse(isThesis() ? WindowOrigin.CORNER : WindowOrigin.CENTRE);
    }

    /** The same with a number of terms of an expansion. */
    public PlanRequest withTerms(ExpansionKind kind, int count) {
        return new PlanRequest(
                preset,
                tolerance,
                Optional.of(kind),
                OptionalInt.of(count),
                radius,
                anchor,
                wavelengthStep,
                origin,
                coherenceLength,
                average);
    }

    /** The same with another window: four standard deviations in metres, and its place. */
    public PlanRequest withWindow(double coherenceLengthMetres, WindowOrigin place) {
        return new PlanRequest(
                preset,
                tolerance,
                expansion,
                terms,
                radius,
                anchor,
                wavelengthStep,
                Optional.of(place),
                OptionalDouble.of(coherenceLengthMetres),
                average);
    }
}
