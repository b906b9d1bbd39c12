package sunbeam.app.commands.figures;

import java.nio.file.Path;
import java.util.Optional;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.setting.Choices;

/** One picture of a figure. */
sealed interface Panel {
    /** The picture's file name without folder and extension. */
    String name();

    /** Which patch. */
    Role role();

    /** What sets this picture apart from its neighbours. */
    String label();

    /** The picture's file. */
    default Path file(Path folder) {
        return folder.resolve(name() + ".png");
    }

    /**
     * A BRDF map.
     *
     * @param thetaDegrees of the light to the normal; its azimuth is 0
     * @param base the map whose exposure this one takes and from which its difference is told; empty for a map with
     *     its own exposure
     */
    record MapPanel(String name, Role role, String label, double thetaDegrees, Method method, Optional<MapPanel> base)
            implements Panel {}

    /**
     * A response over wavelengths and angles, light at 75 degrees.
     *
     * @param choices what is chosen of method {@code full}
     */
    record ResponsePanel(String name, Role role, String label, Choices choices) implements Panel {}
}
