package sunbeam.app.viewer;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import sunbeam.precompute.analysis.SpatialFrequency;
import sunbeam.precompute.color.ColorName;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Lengths;

/**
 * Sentence about a picked point: "blue, first order of 1.54 um; light at 62 degrees, you at 23".
 *
 * @param light direction to the light, tangent frame
 * @param viewer direction to the viewer, tangent frame
 * @param waves spatial frequencies of the surface's gratings, tangent frame; empty if unknown or none
 * @param spread largest distance of (u, v) from an order's that still shows its color: two deviations of the skin's slopes, doubled by reflection
 * @param isOfMany true under an environment: the light is its brightest, and no order of that light alone makes the color
 */
record PickSentence(Direction light, Direction viewer, List<SpatialFrequency> waves, double spread, boolean isOfMany) {
    /** Spread on a perfect surface under a point: the directions of a scan's lines differ by a degree or two. */
    static final double LEAST_SPREAD = 0.04;

    private static final List<String> ORDINALS = List.of("first", "second", "third", "fourth", "fifth");

    /** An order that may make the color; distance of its wavelength, meters, from those of the color. */
    private record Candidate(int order, SpatialFrequency wave, double distance) {}

    /** @param color name of the color on screen; empty while it is not final */
    String words(Optional<ColorName> color) {
        return color.map(name -> name.words() + order(name) + "; ").orElse("") + angles();
    }

    private String angles() {
        String name = isOfMany ? "brightest light" : "light";
        if (light.z() <= 0) {
            return "the " + name + " is behind the skin here";
        }
        return name + Text.format(" at %.0f degrees, you at %.0f", degrees(light), degrees(viewer));
    }

    private static double degrees(Direction direction) {
        return Math.toDegrees(Math.acos(Math.max(-1, Math.min(1, direction.z()))));
    }

    /** Solves the grating equation, (u, v) = order times wavelength times spatial frequency, for an order whose wavelength shows the color. */
    private String order(ColorName color) {
        double u = -light.x() - viewer.x();
        double v = -light.y() - viewer.y();
        if (light.z() <= 0 || isOfMany) {
            return "";
        }
        if (Math.hypot(u, v) < LEAST_SPREAD) {
            return ", the mirror's direction";
        }
        return waves.stream()
                .filter(wave -> Math.abs(u * wave.y() - v * wave.x()) <= spread * wave.length())
                .flatMap(wave -> IntStream.rangeClosed(1, ORDINALS.size()).mapToObj(order -> {
                    double wavelength = Math.abs(u * wave.x() + v * wave.y()) / (wave.length() * wave.length()) / order;
                    double blur = spread / (order * wave.length());
                    return new Candidate(order, wave, color.distance(wavelength) - blur);
                }))
                .filter(candidate -> candidate.distance() <= 0)
                .min(Comparator.comparingDouble(Candidate::distance))
                .map(found -> ", " + ORDINALS.get(found.order() - 1) + " order of "
                        + Lengths.rounded(found.wave().period(), 3))
                .orElse("");
    }
}
