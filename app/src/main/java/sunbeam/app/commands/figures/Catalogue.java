package sunbeam.app.commands.figures;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.optics.WindowOrigin;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.setting.Choices;

/** All figures, in the thesis's order. */
final class Catalogue {
    /** Lines of the grating for gem: the blazed grating's period, 2.5 um, for all patches. */
    private static final double GEM_SPACING = 2.5e-6;

    private static final Map<Role, String> RESPONSES =
            Map.of(Role.BLAZE, "4.9", Role.ELAPHE, "4.10", Role.XENOPELTIS, "4.11");

    private Catalogue() {}

    static List<Figure> all() {
        List<Figure> figures = new ArrayList<>();
        for (Role role : Role.values()) {
            figures.add(response(role));
        }
        figures.addAll(MapFigures.all(GEM_SPACING));
        return figures;
    }

    /**
     * The figures with these numbers.
     *
     * @throws UsageException for a number that is none of a figure
     */
    static List<Figure> select(List<String> numbers) {
        List<Figure> all = all();
        List<String> known = all.stream().map(Figure::number).toList();
        for (String number : numbers) {
            if (!known.contains(number)) {
                throw new UsageException(
                        "--only " + number + ": no such figure; choose from " + String.join(", ", known));
            }
        }
        return numbers.isEmpty()
                ? all
                : all.stream()
                        .filter(figure -> numbers.contains(figure.number()))
                        .toList();
    }

    /** The window as the thesis has it, on the corner; for Xenopeltis centred, where its ridge is the thesis's. */
    private static Figure response(Role role) {
        WindowOrigin origin = role == Role.XENOPELTIS ? WindowOrigin.CENTRE : WindowOrigin.CORNER;
        Choices choices = Choices.none().with(MethodSettings.WINDOW_ORIGIN, origin);
        String label =
                "response, light at 75 degrees, window on the " + (origin == WindowOrigin.CENTRE ? "centre" : "corner");
        String number = RESPONSES.get(role);
        return new Figure(
                number,
                "Evaluation by the grating equation, " + role.label(),
                "The response over wavelength and angle, the followed ridge of the first order, and the grating equation"
                        + " with the fitted period.",
                List.of(new Panel.ResponsePanel(number + "-" + role.label(), role, label, choices)));
    }
}
