package sunbeam.precompute.method;

import static sunbeam.precompute.plan.MethodSettings.ANCHOR;
import static sunbeam.precompute.plan.MethodSettings.RADIUS;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import sunbeam.precompute.plan.Accuracy;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.Neighbourhood;
import sunbeam.precompute.plan.Neighbourhood.Anchor;
import sunbeam.precompute.plan.TableChoices;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;

/** What the methods have in common that sum over bins under a Gaussian window. */
final class BinSettings {
    private static final int THESIS_RADIUS = 1;

    static final List<Setting<?>> ALL = Stream.of(
                    TableChoices.SETTINGS.stream(), Stream.of(RADIUS, ANCHOR), GaussianArea.SETTINGS.stream())
            .<Setting<?>>flatMap(settings -> settings)
            .toList();

    private BinSettings() {}

    /** The neighbourhood, where anything of it was chosen. An anchor by itself has the thesis's radius or none. */
    static Optional<Neighbourhood> neighbourhood(Choices choices) {
        boolean thesis = Accuracy.of(choices).isThesis();
        if (!choices.has(RADIUS) && !choices.has(ANCHOR)) {
            return Optional.empty();
        }
        if (!choices.has(RADIUS) && !thesis) {
            throw choices.complaint(
                    ANCHOR,
                    "is the middle of a neighbourhood of bins, but no radius is given; add for example ",
                    RADIUS,
                    " 3, or leave ",
                    ANCHOR,
                    " out");
        }
        return Optional.of(new Neighbourhood(
                choices.get(RADIUS, THESIS_RADIUS), choices.get(ANCHOR, thesis ? Anchor.FLOOR : Anchor.NEAREST)));
    }
}
