package sunbeam.app.scene;

import sunbeam.precompute.text.Quoted;
import sunbeam.precompute.units.Lengths;

/** Coordinates as scene files have them: texts with their units. */
final class SceneUnits {
    private SceneUnits() {}

    /** A coordinate to metres. */
    static double coordinate(String text) {
        double metres = Lengths.parse(text);
        if (!(Math.abs(metres) <= 1e6)) {
            throw new IllegalArgumentException(Quoted.of(text) + " is out of range; give at most 1000 km");
        }
        return metres;
    }

    /** Metres as text, exactly. */
    static String coordinateText(float metres) {
        return number(metres) + " m";
    }

    /** A number without a superfluous ".0". */
    static String number(double value) {
        // Values that were floats are shown with a float's digits.
        String text = (float) value == value ? Float.toString((float) value) : Double.toString(value);
        return text.endsWith(".0") ? text.substring(0, text.length() - 2) : text;
    }
}
